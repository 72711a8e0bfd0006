// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "specplan/lattice/Neighbourhood.h"

namespace specplan::lattice
{
/// Box of a grid of any dimension, in lattice steps; both ends belong to it.
struct GridBox
{
    std::vector<Coordinate> lower;
    std::vector<Coordinate> upper;
};

/// What distinguishes the steps of a grid.
struct GridSteps
{
    /// How many axes may change in one step, 1 to the dimension: in the plane 1 gives 4 neighbours and 2 gives 8.
    unsigned connectivity = 2;

    /// Lattice units of one step along an axis, at least 1.
    Coordinate stride = 1;

    /// If false, a step that changes several axes needs the states at all corners of the box that it spans to be valid.
    bool cornerCutting = true;

    /// Cost of a step by its offset, greater than 0.
    std::function<double(std::span<const Coordinate> offset)> cost;

    /// Whether a motion by this offset needs a check of its own; none does if this is empty.
    std::function<bool(std::span<const Coordinate> offset)> motionCheck;
};

/// Axis-aligned grid: a step changes up to `connectivity` coordinates by one stride.
class GridNeighbourhood : public Neighbourhood
{
public:
    /// \throws std::invalid_argument if the box is empty or its ends differ in size, connectivity is out of range, a
    /// step costs nothing, or there would be more than 65536 steps.
    GridNeighbourhood(GridBox box, const GridSteps& steps);

    [[nodiscard]] std::size_t dimension() const noexcept override
    {
        return box_.lower.size();
    }

    [[nodiscard]] std::uint32_t maxSteps() const noexcept override
    {
        return static_cast<std::uint32_t>(patterns_.size());
    }

    [[nodiscard]] std::span<const Pattern> patterns() const noexcept override
    {
        return patterns_;
    }

    [[nodiscard]] bool hasMotionChecks() const noexcept override
    {
        return hasMotionChecks_;
    }

    void steps(const Coordinate* from, Steps& out) const override;
    bool goOn(const Coordinate* from, const Coordinate* to, Coordinate* next) const override;

    /// Whether the coordinates lie inside the box.
    [[nodiscard]] bool contains(const Coordinate* coordinates) const noexcept;

private:
    void addDirections(const GridSteps& steps);
    void addGuards(std::uint32_t step);
    [[nodiscard]] std::span<const Coordinate> offsetOf(std::uint32_t step) const;
    [[nodiscard]] std::uint32_t stepBy(std::span<const Coordinate> offset) const;

    GridBox box_;
    Coordinate stride_;
    std::vector<Pattern> patterns_;    ///< one for each direction
    std::vector<Coordinate> offsets_;  ///< a row for each direction
    bool hasMotionChecks_ = false;
};
}  // namespace specplan::lattice
