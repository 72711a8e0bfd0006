// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <compare>
#include <cstdint>

#include "specplan/lattice/NodeTable.h"

namespace specplan::lattice
{
/// Dense number of a motion whose inside can be checked.
using MotionId = std::uint32_t;

/// Names one check: of a node's state, or of the inside of a motion.
class CheckId
{
public:
    CheckId() = default;

    [[nodiscard]] static CheckId ofState(NodeId node) noexcept
    {
        return CheckId(node);
    }

    [[nodiscard]] static CheckId ofMotion(MotionId motion) noexcept
    {
        return CheckId(motion | kMotionBit);
    }

    [[nodiscard]] bool isMotion() const noexcept
    {
        return (value_ & kMotionBit) != 0;
    }

    [[nodiscard]] NodeId node() const noexcept
    {
        assert(!isMotion());
        return value_;
    }

    [[nodiscard]] MotionId motion() const noexcept
    {
        assert(isMotion());
        return value_ & ~kMotionBit;
    }

    auto operator<=>(const CheckId&) const = default;

private:
    explicit CheckId(std::uint32_t value) noexcept : value_(value)
    {
    }

    static constexpr std::uint32_t kMotionBit = std::uint32_t{1} << 31;

    std::uint32_t value_ = 0;
};
}  // namespace specplan::lattice
