// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/BestPath.h"

#include <utility>
#include <vector>

#include <ompl/base/OptimizationObjective.h>

#include "specplan/planner/StateHandle.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
/// The goal gets a copy of the state, should it write into it.
bool endsIn(const ompl::geometric::PathGeometric& path, const ob::Goal& goal)
{
    const ob::State* last = path.getState(static_cast<unsigned>(path.getStateCount() - 1));
    return goal.isSatisfied(StateHandle(*path.getSpaceInformation(), last).get());
}
}  // namespace

void BestPath::reset()
{
    cost_.reset();
    path_.reset();
}

bool BestPath::leadsTo(const ob::Goal& goal) const
{
    return !satisfied_ || endsIn(*path_, goal);
}

void BestPath::take(Path path, ob::Cost cost, const ob::Planner& planner)
{
    satisfied_ = endsIn(*path, *planner.getProblemDefinition()->getGoal());
    path_ = std::move(path);
    cost_ = cost;
    if (const auto& callback = planner.getProblemDefinition()->getIntermediateSolutionCallback())
    {
        const std::vector<ob::State*>& states = path_->getStates();
        callback(&planner, std::vector<const ob::State*>(states.begin(), states.end()), cost);
    }
    publish(planner);
}

void BestPath::publish(const ob::Planner& planner) const
{
    const ob::ProblemDefinitionPtr& pdef = planner.getProblemDefinition();
    for (const ob::PlannerSolution& known : pdef->getSolutions())
        if (known.path_ == path_)
            return;
    ob::PlannerSolution solution(path_);
    solution.setPlannerName(planner.getName());
    if (const ob::OptimizationObjectivePtr& objective = pdef->getOptimizationObjective())
        solution.setOptimized(objective, *cost_, objective->isSatisfied(*cost_));
    pdef->addSolutionPath(solution);
}
}  // namespace specplan::planner
