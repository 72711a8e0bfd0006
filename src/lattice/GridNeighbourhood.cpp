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
            Direction direction{offset, {}, steps.cost(offset), steps.motionCheck && steps.motionCheck(offset)};
            if (!(direction.cost > 0.0) || !std::isfinite(direction.cost))
                throw std::invalid_argument("every step of a grid needs a finite cost greater than 0");
            if (!steps.cornerCutting)
                direction.guards = guardOffsets(offset);
            hasMotionChecks_ = hasMotionChecks_ || direction.motionCheck;
            directions_.push_back(std::move(direction));
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
    out.clear();
    for (std::uint32_t index = 0; index < directions_.size(); ++index)
    {
        const Direction& direction = directions_[index];
        const std::size_t row = out.ends.size();
        out.ends.resize(row + n);
        bool inside = true;
        for (std::size_t axis = 0; axis < n; ++axis)
        {
            const Coordinate end = from[axis] + direction.offset[axis];
            inside = inside && end >= box_.lower[axis] && end <= box_.upper[axis];
            out.ends[row + axis] = end;
        }
        if (!inside)
        {
            out.ends.resize(row);
            continue;
        }
        const auto guards = static_cast<std::uint16_t>(direction.guards.size() / n);
        out.steps.push_back({direction.cost, index, static_cast<std::uint32_t>(out.guards.size() / n), guards,
                             direction.motionCheck});
        for (std::size_t i = 0; i < direction.guards.size(); ++i)
            out.guards.push_back(from[i % n] + direction.guards[i]);
    }
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
