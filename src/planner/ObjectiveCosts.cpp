// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/ObjectiveCosts.h"

#include <algorithm>
#include <cmath>
#include <typeinfo>

#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/util/Exception.h>

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::MotionId;
using lattice::NodeId;

bool isPathLength(const ob::OptimizationObjective& objective)
{
    return typeid(objective) == typeid(ob::PathLengthOptimizationObjective);
}

bool asksNoChecker(const ob::OptimizationObjective& objective)
{
    const std::type_info& type = typeid(objective);
    if (type == typeid(ob::MultiOptimizationObjective))
    {
        const auto& several = static_cast<const ob::MultiOptimizationObjective&>(objective);
        for (std::size_t i = 0; i < several.getObjectiveCount(); ++i)
            if (!asksNoChecker(*several.getObjective(static_cast<unsigned>(i))))
                return false;
        return true;
    }
    return type == typeid(ob::PathLengthOptimizationObjective) ||
           type == typeid(ob::MechanicalWorkOptimizationObjective) || type == typeid(ob::StateCostIntegralObjective);
}

ObjectiveCosts::ObjectiveCosts(const ob::SpaceInformation& si, const ob::OptimizationObjective& objective,
                               const lattice::Lattice& lattice, const Embedding& embedding)
    : objective_(objective), lattice_(lattice), embedding_(embedding), from_(si), to_(si)
{
    const ob::Cost one(1.0);
    const ob::Cost two(2.0);
    const bool smaller = objective.isCostBetterThan(one, two);
    if (smaller == objective.isCostBetterThan(two, one))
        throw ompl::Exception("the objective '" + objective.getDescription() +
                              "' prefers neither smaller nor larger costs, so there is no best path");
    sign_ = smaller ? 1.0 : -1.0;
    adds_ = smaller && objective.identityCost().value() == 0.0 && objective.combineCosts(one, two).value() == 3.0;
}

void ObjectiveCosts::makeRoom(std::size_t motions)
{
    costs_.growTo(motions);
}

double ObjectiveCosts::ofMotion(const ob::State* from, const ob::State* to) const
{
    const double cost = number(objective_.motionCost(from, to));
    if (std::isnan(cost))
        throw ompl::Exception("the objective '" + objective_.getDescription() + "' has a motion whose cost is NaN");
    return adds_ ? std::max(cost, 0.0) : cost;
}

double ObjectiveCosts::ofMotion(const ob::State* from, NodeId end, const ob::State* to) const
{
    return withEnd(ofMotion(from, to), end);
}

void ObjectiveCosts::evaluate(MotionId motion, const ob::State* from, const ob::State* to)
{
    costs_[motion] = ofMotion(from, to);
}

void ObjectiveCosts::setTerminalCost(NodeId node, double cost)
{
    terminalCosts_[node] = cost;
}

double ObjectiveCosts::known(MotionId motion) const
{
    return withEnd(costs_[motion], lattice_.motion(motion).to);
}

double ObjectiveCosts::withEnd(double cost, NodeId end) const
{
    if (terminalCosts_.empty())
        return cost;
    const auto found = terminalCosts_.find(end);
    return found == terminalCosts_.end() ? cost : combine(cost, found->second);
}

double ObjectiveCosts::lowerBound(NodeId from, NodeId to) const
{
    embedding_.write(lattice_, from, from_.get());
    embedding_.write(lattice_, to, to_.get());
    return bound(objective_.motionCostHeuristic(from_.get(), to_.get()));
}

double ObjectiveCosts::bound(ob::Cost cost) const
{
    const double it = number(cost);
    return std::isnan(it) ? identity() : std::max(it, identity());
}

double ObjectiveCosts::combine(double path, double more) const
{
    if (adds_)
        return path + more;
    return std::max(number(objective_.combineCosts(cost(path), cost(more))), path);
}

double ObjectiveCosts::identity() const
{
    return number(objective_.identityCost());
}
}  // namespace specplan::planner
