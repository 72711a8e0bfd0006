// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "specplan/lattice/NodeTable.h"

namespace specplan::lattice
{
/// One independent part of a lattice: some of its coordinates and the steps that change them. A ProductNeighbourhood
/// puts several together.
///
/// Threads: const and without hidden state; any thread.
class Factor
{
public:
    virtual ~Factor() = default;

    /// Number of coordinates, at least 1.
    [[nodiscard]] virtual std::size_t dimension() const noexcept = 0;

    /// Steps are numbered from 0 to this.
    [[nodiscard]] virtual std::uint32_t steps() const noexcept = 0;

    /// How many axes a step changes, at least 1; the same wherever it starts.
    [[nodiscard]] virtual unsigned axes(std::uint32_t step) const noexcept = 0;

    struct Taken
    {
        double cost;   ///< at least 0
        bool checked;  ///< whether the inside of the motion needs a check of its own
    };

    /// What a step costs, if that is the same wherever it starts.
    [[nodiscard]] virtual std::optional<Taken> always(std::uint32_t) const noexcept
    {
        return std::nullopt;
    }

    /// Takes a step: writes its end.
    /// \return false where there is no such step, or where it would leave the bounds.
    virtual bool take(const Coordinate* from, std::uint32_t step, Coordinate* end, Taken& taken) const = 0;
};
}  // namespace specplan::lattice
