// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/ObjectiveCost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <typeinfo>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

namespace specplan::planner
{
namespace ob = ompl::base;

bool isPathLength(const ob::OptimizationObjective& objective)
{
    return typeid(objective) == typeid(ob::PathLengthOptimizationObjective);
}

bool isAdditive(const ob::OptimizationObjective& objective)
{
    const ob::Cost one(1.0);
    const ob::Cost two(2.0);
    return objective.identityCost().value() == 0.0 && objective.combineCosts(one, two).value() == 3.0 &&
           objective.isCostBetterThan(one, two) && !objective.isCostBetterThan(two, one);
}

ObjectiveCost::ObjectiveCost(const ob::SpaceInformation& si, const ob::OptimizationObjective& objective,
                             const lattice::Lattice& lattice, const RealVectorEmbedding& embedding)
    : si_(si), objective_(objective), lattice_(lattice), embedding_(embedding)
{
}

double ObjectiveCost::operator()(lattice::NodeId from, lattice::NodeId to) const
{
    const StateHandle first(si_);
    const StateHandle second(si_);
    embedding_.write(lattice_, from, first.get());
    embedding_.write(lattice_, to, second.get());
    const double cost = objective_.motionCost(first.get(), second.get()).value();
    return cost > 0.0 ? cost : 0.0;
}

ObjectiveHeuristic::ObjectiveHeuristic(const ob::SpaceInformation& si, const ob::OptimizationObjective& objective,
                                       const lattice::Lattice& lattice, const RealVectorEmbedding& embedding,
                                       const std::vector<StateHandle>& goals)
    : si_(si), objective_(objective), lattice_(lattice), embedding_(embedding), goals_(goals)
{
}

double ObjectiveHeuristic::estimate(lattice::NodeId node) const
{
    const StateHandle state(si_);
    embedding_.write(lattice_, node, state.get());
    double nearest = std::numeric_limits<double>::infinity();
    for (const StateHandle& goal : goals_)
        nearest = std::min(nearest, objective_.motionCostHeuristic(state.get(), goal.get()).value());
    return std::isfinite(nearest) && nearest > 0.0 ? nearest : 0.0;
}
}  // namespace specplan::planner
