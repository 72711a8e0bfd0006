// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/lattice/Lattice.h"
#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/StateHandle.h"

namespace specplan::planner
{
/// Puts an axis-aligned grid over a bounded RealVectorStateSpace: which state stands for which lattice node.
///
/// Threads: built by one; `write` may then be called by any. Terminals are added by the search thread before their
/// nodes are handed to workers.
class RealVectorEmbedding
{
public:
    /// \param origin the grid goes exactly through this state.
    /// \throws ompl::Exception if the grid would have more than 2^30 cells along an axis, or spacing does not fit the
    /// space.
    RealVectorEmbedding(const ompl::base::SpaceInformation& si, const PlannerSettings& settings,
                        const ompl::base::State* origin);

    [[nodiscard]] std::size_t dimension() const noexcept
    {
        return spacing_.size();
    }

    /// Lattice spacing of each axis, in the units of the space.
    [[nodiscard]] const std::vector<double>& spacing() const noexcept
    {
        return spacing_;
    }

    /// How many axes may change in one step.
    [[nodiscard]] unsigned connectivity() const noexcept
    {
        return connectivity_;
    }

    /// The nodes whose states lie inside the bounds.
    [[nodiscard]] const lattice::GridBox& box() const noexcept
    {
        return box_;
    }

    /// Whether a node lies inside the bounds.
    [[nodiscard]] bool contains(const std::vector<lattice::Coordinate>& coordinates) const noexcept;

    /// Place of a state in lattice steps from the origin.
    [[nodiscard]] std::vector<double> position(const ompl::base::State* state) const;

    /// Length of a step in the metric of the space.
    [[nodiscard]] double stepLength(std::span<const lattice::Coordinate> offset) const noexcept;

    /// The corners of the grid cell around a position that lie inside the bounds: those that a straight motion may join
    /// it to. Above ten dimensions only the nearest corner and its neighbours along one axis.
    [[nodiscard]] std::vector<std::vector<lattice::Coordinate>> corners(const std::vector<double>& position) const;

    /// Registers the state of the next terminal that the lattice makes.
    void addTerminal(const ompl::base::State* state);

    /// Writes the state of a node.
    void write(const lattice::Lattice& lattice, lattice::NodeId node, ompl::base::State* state) const;

private:
    const ompl::base::SpaceInformation& si_;
    std::vector<double> origin_;
    std::vector<double> lower_;
    std::vector<double> upper_;
    std::vector<double> spacing_;
    unsigned connectivity_;
    lattice::GridBox box_;
    std::vector<StateHandle> terminals_;
};

/// Spacing of each axis that the settings stand for, given the extents of the axes.
/// \throws ompl::Exception if the settings give a spacing for another number of axes.
[[nodiscard]] std::vector<double> chooseSpacing(const PlannerSettings& settings, const std::vector<double>& extents);
}  // namespace specplan::planner
