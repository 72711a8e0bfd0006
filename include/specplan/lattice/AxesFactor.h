// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "specplan/lattice/Factor.h"

namespace specplan::lattice
{
/// One axis of an AxesFactor, in lattice units.
struct Axis
{
    Coordinate lower;   ///< smallest coordinate
    Coordinate upper;   ///< greatest coordinate; the axis stands still if it equals `lower`
    Coordinate period;  ///< 0, or the number of units after which the axis comes round: then lower is 0, upper period-1
    Coordinate stride;  ///< units of one step, at least 1
};

/// Axis-aligned grid, any axis of which may wrap around: a step changes up to `connectivity` axes by one stride each.
class AxesFactor : public Factor
{
public:
    /// \param cost of a step by its offset in units. \param checked whether a motion by that offset needs a check of
    /// its own.
    /// \throws std::invalid_argument if there is no axis, or a node would have more than 65536 neighbours.
    AxesFactor(std::vector<Axis> axes, unsigned connectivity,
               const std::function<double(std::span<const Coordinate>)>& cost,
               const std::function<bool(std::span<const Coordinate>)>& checked);

    [[nodiscard]] std::size_t dimension() const noexcept override
    {
        return axes_.size();
    }

    [[nodiscard]] std::uint32_t steps() const noexcept override
    {
        return static_cast<std::uint32_t>(patterns_.size());
    }

    [[nodiscard]] unsigned axes(std::uint32_t step) const noexcept override
    {
        return patterns_[step].axes;
    }

    [[nodiscard]] std::optional<Taken> always(std::uint32_t step) const noexcept override
    {
        return patterns_[step].taken;
    }

    bool take(const Coordinate* from, std::uint32_t step, Coordinate* end, Taken& taken) const override;

private:
    struct Pattern
    {
        Taken taken;
        unsigned axes;
    };

    std::vector<Axis> axes_;
    std::vector<Pattern> patterns_;
    std::vector<Coordinate> offsets_;  ///< a row for each pattern
};
}  // namespace specplan::lattice
