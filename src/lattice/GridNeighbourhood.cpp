// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/GridNeighbourhood.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace specplan::lattice
{
namespace
{
constexpr std::size_t kMaxDirections = 65536;

void requireBox(const GridBox& box)
{
    if (box.lower.empty() || box.lower.size() != box.upper.size())
        throw std::invalid_argument("a grid needs as many lower as upper bounds, and at least one");
    for (std::size_t axis = 0; axis < box.lower.size(); ++axis)
        if (box.lower[axis] > box.upper[axis])
            throw std::invalid_argument("the grid is empty along axis " + std::to_string(axis));
}
}  // namespace

GridNeighbourhood::GridNeighbourhood(GridBox box, const GridSteps& steps) : box_(std::move(box))
{
    requireBox(box_);
    if (steps.connectivity < 1 || steps.connectivity > dimension())
        throw std::invalid_argument("connectivity must be between 1 and the dimension, " +
                                    std::to_string(dimension()));
    addDirections(steps);
}

void GridNeighbourhood::addDirections(const GridSteps& steps)
{
    std::vector<Coordinate> offset(dimension(), -1);
    for (bool more = true; more;)
    {
        const auto changed = static_cast<std::size_t>(std::ranges::count_if(offset, [](auto v) { return v != 0; }));
        if (changed >= 1 && changed <= steps.connectivity)
        {
            Direction direction{{}, steps.cost(offset), steps.motionCheck && steps.motionCheck(offset)};
            if (!(direction.cost > 0.0) || !std::isfinite(direction.cost))
                throw std::invalid_argument("every step of a grid needs a finite cost greater than 0");
            if (!steps.cornerCutting)
                direction.guards = guardOffsets(offset);
            hasMotionChecks_ = hasMotionChecks_ || direction.motionCheck;
            directions_.push_back(std::move(direction));
            offsets_.insert(offsets_.end(), offset.begin(), offset.end());
            if (directions_.size() > kMaxDirections)
                throw std::invalid_argument("a node has more than 65536 neighbours; choose a smaller connectivity");
        }
        // Count through {-1, 0, 1}^n, last axis fastest.
        more = false;
        for (std::size_t axis = dimension(); axis-- > 0 && !more;)
        {
            more = offset[axis] < 1;
            offset[axis] = more ? offset[axis] + 1 : -1;
        }
    }
}

std::vector<Coordinate> GridNeighbourhood::guardOffsets(const std::vector<Coordinate>& offset) const
{
    std::vector<std::size_t> axes;
    for (std::size_t axis = 0; axis < offset.size(); ++axis)
        if (offset[axis] != 0)
            axes.push_back(axis);
    if (axes.size() > 12)
        throw std::invalid_argument("without corner cutting at most 12 axes may change in one step");
    std::vector<Coordinate> guards;
    for (std::size_t subset = 1; subset + 1 < (std::size_t{1} << axes.size()); ++subset)
    {
        std::vector<Coordinate> corner(offset.size(), 0);
        for (std::size_t bit = 0; bit < axes.size(); ++bit)
            if ((subset >> bit & 1U) != 0)
                corner[axes[bit]] = offset[axes[bit]];
        guards.insert(guards.end(), corner.begin(), corner.end());
    }
    return guards;
}

void GridNeighbourhood::steps(const Coordinate* from, Steps& out) const
{
    const std::size_t n = dimension();
    if (out.steps.size() < directions_.size())
        out.steps.resize(directions_.size());
    if (out.ends.size() < offsets_.size())
        out.ends.resize(offsets_.size());
    out.count = 0;
    out.guards.clear();
    bool interior = true;  // all neighbours lie inside the box
    for (std::size_t axis = 0; axis < n; ++axis)
        interior = interior && from[axis] > box_.lower[axis] && from[axis] < box_.upper[axis];
    for (std::uint32_t index = 0; index < directions_.size(); ++index)
    {
        Coordinate* end = &out.ends[out.count * n];
        const Coordinate* offset = &offsets_[index * n];
        for (std::size_t axis = 0; axis < n; ++axis)
            end[axis] = from[axis] + offset[axis];
        if (interior || contains(end))
            addStep(from, index, out);
    }
}

void GridNeighbourhood::addStep(const Coordinate* from, std::uint32_t index, Steps& out) const
{
    const std::size_t n = dimension();
    const Direction& direction = directions_[index];
    out.steps[out.count++] = {direction.cost, index, static_cast<std::uint32_t>(out.guards.size() / n),
                              static_cast<std::uint16_t>(direction.guards.size() / n), direction.motionCheck};
    for (std::size_t i = 0; i < direction.guards.size(); ++i)
        out.guards.push_back(from[i % n] + direction.guards[i]);
}

bool GridNeighbourhood::goOn(const Coordinate* from, const Coordinate* to, Coordinate* next) const
{
    for (std::size_t axis = 0; axis < dimension(); ++axis)
    {
        const Coordinate step = to[axis] - from[axis];
        if (std::abs(step) > 1)
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
