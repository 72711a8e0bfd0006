// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/AxesComponent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ompl/util/Exception.h>

#include "RoundingSlack.h"
#include "specplan/lattice/GridHeuristic.h"
#include "specplan/lattice/GridNeighbourhood.h"

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::Coordinate;

namespace
{
/// A motion this close to one segment is left to the check, which counts the segments from the real states.
constexpr double kSegmentSlack = 1.0 - 1e-9;
constexpr double kMaxUnits = 1 << 30;
constexpr std::size_t kMaxAxesForAllCorners = 10;
/// Axes handled without allocation; more are possible.
constexpr std::size_t kAxesOnStack = 16;

/// Distance of two places along an axis, in units.
double distanceAlong(const lattice::Axis& axis, double a, double b)
{
    const double distance = std::abs(a - b);
    return axis.period > 0 ? std::min(distance, axis.period - distance) : distance;
}

/// Number of values that nodes have along an axis.
Coordinate valuesAlong(const lattice::Axis& axis)
{
    return axis.period > 0 ? axis.period / axis.stride : axis.upper / axis.stride - axis.lower / axis.stride + 1;
}

/// The axis in lattice units; a spacing is so many of them.
lattice::Axis gridAxis(const RealAxis& axis, double unit, Coordinate stride)
{
    if (axis.wraps)
    {
        const auto period = static_cast<Coordinate>(std::llround((axis.upper - axis.lower) / unit));
        return {0, period - 1, period, stride};
    }
    const double down = std::ceil((axis.lower - axis.origin) / unit - kRoundingSlack);
    const double up = std::floor((axis.upper - axis.origin) / unit + kRoundingSlack);
    if (!(std::abs(down) < kMaxUnits && std::abs(up) < kMaxUnits))
        throw ompl::Exception("the lattice has more than 2^30 cells along " + axis.name +
                              "; choose a coarser resolution");
    return {std::min(static_cast<Coordinate>(down), 0), std::max(static_cast<Coordinate>(up), 0), 0, stride};
}
}  // namespace

AxesComponent::AxesComponent(std::vector<RealAxis> axes, Access access, const LatticeOptions& options)
    : axes_(std::move(axes)), access_(std::move(access)), options_(options)
{
    options_.connectivity = std::min(options.connectivity, static_cast<unsigned>(axes_.size()));
    for (RealAxis& axis : axes_)
    {
        const Coordinate stride = axis.whole ? 1 : Coordinate{1} << options.levels;
        if (axis.wraps)
        {
            // A whole number of steps, at least three, so that there is a way round.
            const double extent = axis.upper - axis.lower;
            axis.spacing = extent / std::max(std::round(extent / axis.spacing), 3.0);
        }
        units_.push_back(axis.spacing / stride);
        grid_.push_back(gridAxis(axis, units_.back(), stride));
    }
}

double AxesComponent::length(std::span<const Coordinate> offset) const noexcept
{
    double squared = 0.0;
    for (std::size_t axis = 0; axis < units_.size(); ++axis)
        squared += offset[axis] * units_[axis] * (offset[axis] * units_[axis]);
    return std::sqrt(squared);
}

bool AxesComponent::needsCheck(std::span<const Coordinate> offset, bool discreteMotions) const noexcept
{
    return !discreteMotions || length(offset) > options_.longest * kSegmentSlack;
}

bool AxesComponent::isPlain() const noexcept
{
    return std::ranges::all_of(
        grid_, [this](const lattice::Axis& axis) { return axis.period == 0 && axis.stride == grid_.front().stride; });
}

std::unique_ptr<const lattice::Factor> AxesComponent::factor(bool discreteMotions) const
{
    return std::make_unique<lattice::AxesFactor>(
        grid_, options_.connectivity,
        [this](std::span<const Coordinate> offset) { return options_.weight * length(offset); },
        [this, discreteMotions](std::span<const Coordinate> offset) { return needsCheck(offset, discreteMotions); });
}

std::unique_ptr<const lattice::Neighbourhood> AxesComponent::grid(bool discreteMotions, bool cornerCutting) const
{
    lattice::GridBox box;
    for (const lattice::Axis& axis : grid_)
    {
        box.lower.push_back(axis.lower);
        box.upper.push_back(axis.upper);
    }
    lattice::GridSteps steps;
    steps.connectivity = options_.connectivity;
    steps.stride = grid_.front().stride;
    steps.cornerCutting = cornerCutting;
    steps.cost = [this](std::span<const Coordinate> offset) { return options_.weight * length(offset); };
    steps.motionCheck = [this, discreteMotions](std::span<const Coordinate> offset)
    { return needsCheck(offset, discreteMotions); };
    return std::make_unique<lattice::GridNeighbourhood>(box, steps);
}

bool AxesComponent::canRefine() const noexcept
{
    return std::ranges::any_of(grid_, [](const lattice::Axis& axis) { return axis.stride > 1; });
}

void AxesComponent::refine()
{
    for (lattice::Axis& axis : grid_)
        axis.stride = std::max(axis.stride / 2, 1);
}

void AxesComponent::coarsen()
{
    for (std::size_t axis = 0; axis < grid_.size(); ++axis)
        if (!axes_[axis].whole && grid_[axis].stride <= std::numeric_limits<Coordinate>::max() / 2)
            grid_[axis].stride *= 2;
}

double AxesComponent::coarseness() const
{
    double longest = 0.0;
    for (std::size_t axis = 0; axis < units_.size(); ++axis)
        if (!axes_[axis].whole)
            longest = std::max(longest, units_[axis] * grid_[axis].stride);
    return options_.longest > 0.0 ? longest / options_.longest : std::numeric_limits<double>::infinity();
}

void AxesComponent::write(const Coordinate* node, ob::State* state) const
{
    double few[kAxesOnStack];
    std::vector<double> many(axes_.size() > kAxesOnStack ? axes_.size() : 0);
    double* values = many.empty() ? few : many.data();
    for (std::size_t i = 0; i < axes_.size(); ++i)
    {
        const RealAxis& axis = axes_[i];
        double value = axis.origin + node[i] * units_[i];
        if (axis.wraps && value >= axis.upper)
            value -= axis.upper - axis.lower;
        values[i] = std::clamp(value, axis.lower, axis.upper);
        if (axis.wraps && values[i] == axis.upper)
            values[i] = axis.lower;  // SO2 is half open
    }
    access_.write(values, state);
}

std::vector<double> AxesComponent::position(const ob::State* state) const
{
    std::vector<double> position(axes_.size());
    access_.read(state, position.data());
    for (std::size_t i = 0; i < axes_.size(); ++i)
    {
        position[i] = (position[i] - axes_[i].origin) / units_[i];
        if (grid_[i].period > 0 && position[i] < 0.0)
            position[i] += grid_[i].period;
    }
    return position;
}

std::vector<Component::Coordinates> AxesComponent::corners(const ob::State* state, Joint) const
{
    const std::vector<double> place = position(state);
    const std::size_t n = axes_.size();
    Coordinates nearest(n);
    Coordinates other(n);  // the farther end of the cell along each axis; the same if the state is on the grid
    const auto wrapped = [this](std::size_t i, Coordinate at)
    { return grid_[i].period > 0 ? (at % grid_[i].period + grid_[i].period) % grid_[i].period : at; };
    const auto inside = [this](std::size_t i, Coordinate at) { return at >= grid_[i].lower && at <= grid_[i].upper; };
    for (std::size_t i = 0; i < n; ++i)
    {
        const Coordinate stride = grid_[i].stride;
        const double steps = place[i] / stride;
        const double rounded = std::round(steps);
        const double rest = steps - rounded;
        nearest[i] = wrapped(i, static_cast<Coordinate>(rounded) * stride);
        const Coordinate beyond = std::abs(rest) < kRoundingSlack ? 0 : (rest > 0.0 ? stride : -stride);
        other[i] = wrapped(i, static_cast<Coordinate>(rounded) * stride + beyond);
        if (!inside(i, nearest[i]))
            std::swap(nearest[i], other[i]);
        if (!inside(i, nearest[i]))
            return {};
    }
    std::vector<Coordinates> corners{nearest};
    for (std::size_t i = 0; i < n; ++i)
    {
        if (other[i] == nearest[i] || !inside(i, other[i]))
            continue;
        const std::size_t before = n <= kMaxAxesForAllCorners ? corners.size() : 1;
        for (std::size_t k = 0; k < before; ++k)
        {
            Coordinates corner = corners[k];
            corner[i] = other[i];
            corners.push_back(std::move(corner));
        }
    }
    return corners;
}

double AxesComponent::alongGrid(std::span<const double> distance) const
{
    return lattice::gridDistance(distance, units_, options_.connectivity);
}

Component::Target AxesComponent::target(const ob::State* state, bool) const
{
    Target target{position(state), nullptr, 0.0};
    std::vector<double> approach(axes_.size());
    for (const Coordinates& corner : corners(state, Joint::Entering))
    {
        double squared = 0.0;
        for (std::size_t i = 0; i < axes_.size(); ++i)
        {
            approach[i] = distanceAlong(grid_[i], target.values[i], corner[i]);
            squared += approach[i] * units_[i] * (approach[i] * units_[i]);
        }
        target.saving = std::max(target.saving, alongGrid(approach) - std::sqrt(squared));
    }
    return target;
}

double AxesComponent::lowerBound(const Coordinate* node, const Target& target) const
{
    double few[kAxesOnStack];
    std::vector<double> many(axes_.size() > kAxesOnStack ? axes_.size() : 0);
    const std::span<double> distance(many.empty() ? few : many.data(), axes_.size());
    double squared = 0.0;
    for (std::size_t i = 0; i < axes_.size(); ++i)
    {
        distance[i] = distanceAlong(grid_[i], target.values[i], node[i]);
        squared += distance[i] * units_[i] * (distance[i] * units_[i]);
    }
    double length = alongGrid(distance);
    if (target.saving > 0.0)
        length = std::max(std::sqrt(squared), length - target.saving);
    return options_.weight * length;
}

double AxesComponent::nodes() const
{
    double nodes = 1.0;
    for (const lattice::Axis& axis : grid_)
        nodes *= static_cast<double>(valuesAlong(axis));
    return nodes;
}

void AxesComponent::describe(std::ostream& out) const
{
    for (std::size_t i = 0; i < axes_.size(); ++i)
    {
        const RealAxis& axis = axes_[i];
        const Coordinate values = valuesAlong(grid_[i]);
        out << "  " << axis.name << ": " << axis.lower << " to " << axis.upper
            << (axis.wraps ? ", wraps around, " : ", ");
        if (values == 1)
            out << "stands still\n";
        else
            out << values << " values, spacing " << units_[i] * grid_[i].stride << '\n';
    }
}
}  // namespace specplan::planner
