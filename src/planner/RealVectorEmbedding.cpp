// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/RealVectorEmbedding.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::Coordinate;

namespace
{
/// A node this much of a step outside the bounds counts as on them; its state is moved onto them.
constexpr double kRoundingSlack = 1e-9;
constexpr double kMaxCells = 1 << 30;
constexpr std::size_t kMaxAxesForAllCorners = 10;
/// Automatic resolution: about this many nodes, and at most so many cells along an axis.
constexpr double kAutomaticNodes = 60000.0;
constexpr double kAutomaticCells = 100.0;

const double* valuesOf(const ob::State* state)
{
    return state->as<ob::RealVectorStateSpace::StateType>()->values;
}
}  // namespace

std::vector<double> chooseSpacing(const PlannerSettings& settings, const std::vector<double>& extents)
{
    const std::size_t n = extents.size();
    if (settings.spacing.size() == 1)
        return std::vector<double>(n, settings.spacing.front());
    if (!settings.spacing.empty())
    {
        if (settings.spacing.size() != n)
            throw ompl::Exception("spacing has " + std::to_string(settings.spacing.size()) + " values; the space has " +
                                  std::to_string(n) + " axes: give one value, or one for each axis");
        return settings.spacing;
    }
    double fraction = settings.resolution;
    if (fraction == 0.0)
        fraction =
            1.0 / std::clamp(std::floor(std::pow(kAutomaticNodes, 1.0 / static_cast<double>(n))), 4.0, kAutomaticCells);
    std::vector<double> spacing;
    spacing.reserve(extents.size());
    for (const double extent : extents)
        spacing.push_back(extent * fraction);
    return spacing;
}

RealVectorEmbedding::RealVectorEmbedding(const ob::SpaceInformation& si, const PlannerSettings& settings,
                                         const ob::State* origin)
    : si_(si)
{
    const ob::RealVectorBounds& bounds = si.getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds();
    lower_ = bounds.low;
    upper_ = bounds.high;
    spacing_ = chooseSpacing(settings, bounds.getDifference());
    const std::size_t n = spacing_.size();
    origin_.assign(valuesOf(origin), valuesOf(origin) + n);
    connectivity_ = settings.connectivity != 0 ? settings.connectivity : (n <= 3 ? static_cast<unsigned>(n) : 2U);
    if (connectivity_ > n)
        throw ompl::Exception("connectivity is " + std::to_string(connectivity_) + "; the space has only " +
                              std::to_string(n) + " axes");
    for (std::size_t axis = 0; axis < n; ++axis)
    {
        const double down = std::ceil((lower_[axis] - origin_[axis]) / spacing_[axis] - kRoundingSlack);
        const double up = std::floor((upper_[axis] - origin_[axis]) / spacing_[axis] + kRoundingSlack);
        if (!(std::abs(down) < kMaxCells && std::abs(up) < kMaxCells))
            throw ompl::Exception("the lattice has more than 2^30 cells along axis " + std::to_string(axis) +
                                  "; choose a coarser resolution");
        box_.lower.push_back(std::min(static_cast<Coordinate>(down), 0));
        box_.upper.push_back(std::max(static_cast<Coordinate>(up), 0));
    }
}

bool RealVectorEmbedding::contains(const std::vector<Coordinate>& coordinates) const noexcept
{
    for (std::size_t axis = 0; axis < dimension(); ++axis)
        if (coordinates[axis] < box_.lower[axis] || coordinates[axis] > box_.upper[axis])
            return false;
    return true;
}

std::vector<double> RealVectorEmbedding::position(const ob::State* state) const
{
    std::vector<double> position(dimension());
    for (std::size_t axis = 0; axis < dimension(); ++axis)
        position[axis] = (valuesOf(state)[axis] - origin_[axis]) / spacing_[axis];
    return position;
}

double RealVectorEmbedding::stepLength(std::span<const Coordinate> offset) const noexcept
{
    double squared = 0.0;
    for (std::size_t axis = 0; axis < dimension(); ++axis)
        squared += offset[axis] * spacing_[axis] * (offset[axis] * spacing_[axis]);
    return std::sqrt(squared);
}

std::vector<std::vector<Coordinate>> RealVectorEmbedding::corners(const std::vector<double>& position) const
{
    const std::size_t n = dimension();
    std::vector<Coordinate> nearest(n);
    std::vector<Coordinate> other(
        n);  // the farther end of the cell along each axis; the same if the position is on the grid
    for (std::size_t axis = 0; axis < n; ++axis)
    {
        const double rounded = std::round(position[axis]);
        nearest[axis] = static_cast<Coordinate>(rounded);
        const double rest = position[axis] - rounded;
        other[axis] = nearest[axis] + (std::abs(rest) < kRoundingSlack ? 0 : (rest > 0.0 ? 1 : -1));
    }
    std::vector<std::vector<Coordinate>> corners{nearest};
    for (std::size_t axis = 0; axis < n; ++axis)
    {
        if (other[axis] == nearest[axis])
            continue;
        const std::size_t before = n <= kMaxAxesForAllCorners ? corners.size() : 1;
        for (std::size_t i = 0; i < before; ++i)
        {
            std::vector<Coordinate> corner = corners[i];
            corner[axis] = other[axis];
            corners.push_back(std::move(corner));
        }
    }
    std::erase_if(corners, [this](const std::vector<Coordinate>& corner) { return !contains(corner); });
    return corners;
}

void RealVectorEmbedding::addTerminal(const ob::State* state)
{
    terminals_.emplace_back(si_, state);
}

void RealVectorEmbedding::write(const lattice::Lattice& lattice, lattice::NodeId node, ob::State* state) const
{
    if (lattice.isTerminal(node))
    {
        si_.copyState(state, terminals_[lattice.terminalIndex(node)].get());
        return;
    }
    double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    const std::span<const Coordinate> coordinates = lattice.coordinates(node);
    for (std::size_t axis = 0; axis < coordinates.size(); ++axis)
        values[axis] = std::clamp(origin_[axis] + coordinates[axis] * spacing_[axis], lower_[axis], upper_[axis]);
}
}  // namespace specplan::planner
