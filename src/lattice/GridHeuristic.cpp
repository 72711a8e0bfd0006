// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/GridHeuristic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace specplan::lattice
{
namespace
{
/// Axes handled without allocation; more are possible.
constexpr std::size_t kInlineAxes = 16;

struct AxisDistance
{
    double steps;
    double squaredSpacing;
};

/// Length of the greedy chain: see gridDistance.
double chainLength(std::span<AxisDistance> axes)
{
    std::ranges::sort(axes, {}, &AxisDistance::steps);
    double squared = 0.0;
    for (const AxisDistance& axis : axes)
        squared += axis.squaredSpacing;
    double length = 0.0;
    double done = 0.0;
    for (const AxisDistance& axis : axes)
    {
        length += (axis.steps - done) * std::sqrt(std::max(squared, 0.0));
        squared -= axis.squaredSpacing;
        done = axis.steps;
    }
    return length;
}

double euclideanLength(std::span<const double> distance, std::span<const double> spacing)
{
    double squared = 0.0;
    for (std::size_t axis = 0; axis < distance.size(); ++axis)
        squared += distance[axis] * distance[axis] * spacing[axis] * spacing[axis];
    return std::sqrt(squared);
}
}  // namespace

double gridDistance(std::span<const double> distance, std::span<const double> spacing, unsigned connectivity)
{
    if (connectivity == 1)
    {
        double length = 0.0;
        for (std::size_t axis = 0; axis < distance.size(); ++axis)
            length += std::abs(distance[axis]) * spacing[axis];
        return length;
    }
    if (distance.size() == 2)
    {
        const double a = std::abs(distance[0]);
        const double b = std::abs(distance[1]);
        const double diagonal = std::min(a, b);
        return diagonal * std::sqrt(spacing[0] * spacing[0] + spacing[1] * spacing[1]) + (a - diagonal) * spacing[0] +
               (b - diagonal) * spacing[1];
    }
    std::array<AxisDistance, kInlineAxes> few;
    std::vector<AxisDistance> many;
    std::span<AxisDistance> axes(few.data(), std::min(distance.size(), kInlineAxes));
    if (distance.size() > kInlineAxes)
    {
        many.resize(distance.size());
        axes = many;
    }
    for (std::size_t axis = 0; axis < distance.size(); ++axis)
        axes[axis] = {std::abs(distance[axis]), spacing[axis] * spacing[axis]};
    return chainLength(axes);
}

GridHeuristic::GridHeuristic(const Lattice& lattice, std::vector<double> spacing, unsigned connectivity)
    : lattice_(lattice), spacing_(std::move(spacing)), connectivity_(connectivity)
{
}

void GridHeuristic::addGoal(Goal goal)
{
    double saving = 0.0;
    for (const std::vector<double>& approach : goal.approaches)
        saving =
            std::max(saving, gridDistance(approach, spacing_, connectivity_) - euclideanLength(approach, spacing_));
    goals_.push_back({std::move(goal.position), saving});
}

double GridHeuristic::estimate(NodeId node) const
{
    if (lattice_.isTerminal(node))
        return 0.0;
    const std::span<const Coordinate> coordinates = lattice_.coordinates(node);
    std::array<double, kInlineAxes> few;
    if (coordinates.size() <= kInlineAxes)
    {
        std::ranges::copy(coordinates, few.begin());
        return estimateFrom(few.data());
    }
    const std::vector<double> many(coordinates.begin(), coordinates.end());
    return estimateFrom(many.data());
}

double GridHeuristic::estimateFrom(const double* position) const
{
    const std::size_t n = spacing_.size();
    std::array<double, kInlineAxes> few;
    std::vector<double> many(n > kInlineAxes ? n : 0);
    const std::span<double> distance(n > kInlineAxes ? many.data() : few.data(), n);
    double nearest = goals_.empty() ? 0.0 : std::numeric_limits<double>::infinity();
    for (const Target& goal : goals_)
    {
        for (std::size_t axis = 0; axis < n; ++axis)
            distance[axis] = goal.position[axis] - position[axis];
        double length = gridDistance(distance, spacing_, connectivity_);
        if (goal.saving > 0.0)
            length = std::max(euclideanLength(distance, spacing_), length - goal.saving);
        nearest = std::min(nearest, length);
    }
    return nearest;
}
}  // namespace specplan::lattice
