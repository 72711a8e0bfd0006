// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/OptimizationObjective.h>

#include "specplan/lattice/Heuristic.h"
#include "specplan/planner/RealVectorEmbedding.h"

namespace specplan::planner
{
/// Whether the objective is exactly path length, for which the lattice knows costs and a good heuristic itself.
[[nodiscard]] bool isPathLength(const ompl::base::OptimizationObjective& objective);

/// Whether the objective adds up motion costs as numbers, as this search does.
[[nodiscard]] bool isAdditive(const ompl::base::OptimizationObjective& objective);

/// Cost of motions by the objective.
class ObjectiveCost
{
public:
    ObjectiveCost(const ompl::base::SpaceInformation& si, const ompl::base::OptimizationObjective& objective,
                  const lattice::Lattice& lattice, const RealVectorEmbedding& embedding);

    [[nodiscard]] double operator()(lattice::NodeId from, lattice::NodeId to) const;

private:
    const ompl::base::SpaceInformation& si_;
    const ompl::base::OptimizationObjective& objective_;
    const lattice::Lattice& lattice_;
    const RealVectorEmbedding& embedding_;
};

/// The objective's own state-to-state heuristic, to the nearest of the goals.
class ObjectiveHeuristic : public lattice::Heuristic
{
public:
    /// \param goals must outlive the heuristic.
    ObjectiveHeuristic(const ompl::base::SpaceInformation& si, const ompl::base::OptimizationObjective& objective,
                       const lattice::Lattice& lattice, const RealVectorEmbedding& embedding,
                       const std::vector<StateHandle>& goals);

    [[nodiscard]] double estimate(lattice::NodeId node) const override;

private:
    const ompl::base::SpaceInformation& si_;
    const ompl::base::OptimizationObjective& objective_;
    const lattice::Lattice& lattice_;
    const RealVectorEmbedding& embedding_;
    const std::vector<StateHandle>& goals_;
};
}  // namespace specplan::planner
