// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "specplan/lattice/Heuristic.h"
#include "specplan/lattice/Lattice.h"

namespace specplan::lattice
{
/// Length of the shortest obstacle-free path on an axis-aligned grid: octile distance in the plane, and the same in any
/// dimension and with a spacing of its own for each axis.
///
/// \param distance per axis, in lattice steps; need not be whole. \param spacing of each axis, greater than 0.
/// With every combination of axes allowed in one step the cheapest way is to change all axes together as long as
/// possible, then all but the one that has arrived, and so on: the length of a step is submodular in the set of axes
/// that it changes, and this order is the greedy optimum for such functions (Lovász, 1983). With connectivity below the
/// dimension this is a lower bound, and for connectivity 1 the weighted Manhattan distance is used instead.
[[nodiscard]] double gridDistance(std::span<const double> distance, std::span<const double> spacing,
                                  unsigned connectivity);

/// Path length to the nearest of several goals on a grid; consistent for it.
///
/// A goal between grid nodes is reached from the corners of its cell by a straight motion that may be shorter than any
/// grid path; the greatest such saving is subtracted from the grid distance.
class GridHeuristic : public Heuristic
{
public:
    struct Goal
    {
        std::vector<double> position;                 ///< in lattice steps from the origin
        std::vector<std::vector<double>> approaches;  ///< offsets goal - node of the hand-made motions into it
    };

    GridHeuristic(const Lattice& lattice, std::vector<double> spacing, unsigned connectivity);

    void addGoal(Goal goal);

    /// 0 for terminals: a goal is reached, and nothing better is promised of a start off the grid.
    [[nodiscard]] double estimate(NodeId node) const override;

private:
    struct Target
    {
        std::vector<double> position;
        double saving;
    };

    [[nodiscard]] double estimateFrom(const double* position) const;

    const Lattice& lattice_;
    std::vector<double> spacing_;
    unsigned connectivity_;
    std::vector<Target> goals_;
};
}  // namespace specplan::lattice
