// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/GridNeighbourhood.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "specplan/lattice/Offsets.h"

namespace specplan::lattice
{
namespace
{
void requireBox(const GridBox& box)
{
    if (box.lower.empty() || box.lower.size() != box.upper.size())
        throw std::invalid_argument("a grid needs as many lower as upper bounds, and at least one");
    for (std::size_t axis = 0; axis < box.lower.size(); ++axis)
        if (box.lower[axis] > box.upper[axis])
            throw std::invalid_argument("the grid is empty along axis " + std::to_string(axis));
}
}  // namespace

GridNeighbourhood::GridNeighbourhood(GridBox box, const GridSteps& steps) : box_(std::move(box)), stride_(steps.stride)
{
    requireBox(box_);
    if (stride_ < 1)
        throw std::invalid_argument("the stride of a grid must be at least 1");
    if (steps.connectivity < 1 || steps.connectivity > dimension())
        throw std::invalid_argument("connectivity must be between 1 and the dimension, " + std::to_string(dimension()));
    addDirections(steps);
}

void GridNeighbourhood::addDirections(const GridSteps& steps)
{
    for (Offset& offset : gridOffsets(dimension(), steps.connectivity))
    {
        for (Coordinate& value : offset.values)
            value *= stride_;
        const double cost = steps.cost(offset.values);
        if (!(cost > 0.0) || !std::isfinite(cost))
            throw std::invalid_argument("every step of a grid needs a finite cost greater than 0");
        patterns_.push_back({cost, steps.motionCheck && steps.motionCheck(offset.values), {}});
        hasMotionChecks_ = hasMotionChecks_ || patterns_.back().motionCheck;
        offsets_.insert(offsets_.end(), offset.values.begin(), offset.values.end());
    }
    if (!steps.cornerCutting)
        for (std::uint32_t step = 0; step < maxSteps(); ++step)
            addGuards(step);
}

/// The corners of the box that a step spans are where the steps lead that change some of its axes.
void GridNeighbourhood::addGuards(std::uint32_t step)
{
    const std::span<const Coordinate> offset = offsetOf(step);
    std::vector<std::size_t> axes;
    for (std::size_t axis = 0; axis < offset.size(); ++axis)
        if (offset[axis] != 0)
            axes.push_back(axis);
    assert(axes.size() < 32 && "3 to the power of the axes is below 65536, the most steps");
    for (std::size_t subset = 1; subset + 1 < (std::size_t{1} << axes.size()); ++subset)
    {
        std::vector<Coordinate> corner(offset.size(), 0);
        for (std::size_t bit = 0; bit < axes.size(); ++bit)
            if ((subset >> bit & 1U) != 0)
                corner[axes[bit]] = offset[axes[bit]];
        patterns_[step].guards.push_back(stepBy(corner));
    }
}

std::span<const Coordinate> GridNeighbourhood::offsetOf(std::uint32_t step) const
{
    return std::span(offsets_).subspan(step * dimension(), dimension());
}

/// The step with this offset. They are in lexicographic order.
std::uint32_t GridNeighbourhood::stepBy(std::span<const Coordinate> offset) const
{
    std::uint32_t first = 0;
    for (std::uint32_t count = maxSteps(); count > 0;)
    {
        const std::uint32_t half = count / 2;
        const bool isBehind = std::ranges::lexicographical_compare(offsetOf(first + half), offset);
        first += isBehind ? half + 1 : 0;
        count = isBehind ? count - half - 1 : half;
    }
    assert(first < maxSteps() && std::ranges::equal(offsetOf(first), offset));
    return first;
}

void GridNeighbourhood::steps(const Coordinate* from, Steps& out) const
{
    const std::size_t n = dimension();
    if (out.steps.size() < patterns_.size())
        out.steps.resize(patterns_.size());
    if (out.ends.size() < offsets_.size())
        out.ends.resize(offsets_.size());
    bool interior = true;  // all neighbours lie inside the box
    for (std::size_t axis = 0; axis < n; ++axis)
        interior = interior && from[axis] - stride_ >= box_.lower[axis] && from[axis] + stride_ <= box_.upper[axis];

    Coordinate* end = out.ends.data();
    const Coordinate* offset = offsets_.data();
    Steps::Step* step = out.steps.data();
    for (std::uint32_t index = 0; index < patterns_.size(); ++index)
    {
        for (std::size_t axis = 0; axis < n; ++axis)
            end[axis] = from[axis] + offset[axis];
        offset += n;
        if (!interior && !contains(end))
            continue;
        *step++ = {patterns_[index].cost, index, patterns_[index].motionCheck};
        end += n;
    }
    out.count = static_cast<std::size_t>(step - out.steps.data());
}

bool GridNeighbourhood::goOn(const Coordinate* from, const Coordinate* to, Coordinate* next) const
{
    for (std::size_t axis = 0; axis < dimension(); ++axis)
    {
        const Coordinate step = to[axis] - from[axis];
        if (std::abs(step) > stride_)
            return false;
        next[axis] = to[axis] + step;
    }
    return contains(next);
}

bool GridNeighbourhood::contains(const Coordinate* coordinates) const noexcept
{
    for (std::size_t axis = 0; axis < dimension(); ++axis)
        if (coordinates[axis] < box_.lower[axis] || coordinates[axis] > box_.upper[axis])
            return false;
    return true;
}
}  // namespace specplan::lattice
