// SPDX-License-Identifier: BSD-3-Clause
#include "InterruptiblePlanner.h"

#include <exception>
#include <utility>

#include <ompl/util/Exception.h>

#include "Run.h"

namespace specplan::command
{
namespace ob = ompl::base;

InterruptiblePlanner::InterruptiblePlanner(ob::PlannerPtr planner, std::shared_ptr<const CountingChecker> checker)
    : ob::Planner(planner->getSpaceInformation(), planner->getName()),
      planner_(std::move(planner)),
      checker_(std::move(checker))
{
    specs_ = planner_->getSpecs();
    params_.include(planner_->params());
    for (const auto& [name, read] : planner_->getPlannerProgressProperties())
        addPlannerProgressProperty(name, read);
}

ob::PlannerStatus InterruptiblePlanner::solve(const ob::PlannerTerminationCondition& ptc)
{
    const std::uint64_t before = checker_->calls();
    ob::PlannerStatus status = ob::PlannerStatus::CRASH;
    try
    {
        status = planner_->solve(ob::PlannerTerminationCondition([&ptc] { return ptc() || interrupted(); }));
    }
    catch (const std::exception& error)
    {
        throw ompl::Exception(error.what());
    }
    checks_ = checker_->calls() - before;
    return status;
}

void InterruptiblePlanner::setProblemDefinition(const ob::ProblemDefinitionPtr& pdef)
{
    ob::Planner::setProblemDefinition(pdef);
    planner_->setProblemDefinition(pdef);
}

void InterruptiblePlanner::clear()
{
    ob::Planner::clear();
    planner_->clear();
}

void InterruptiblePlanner::clearQuery()
{
    ob::Planner::clearQuery();
    planner_->clearQuery();
}

void InterruptiblePlanner::setup()
{
    ob::Planner::setup();
    planner_->setup();
}

void InterruptiblePlanner::checkValidity()
{
    ob::Planner::checkValidity();
    planner_->checkValidity();
}

void InterruptiblePlanner::getPlannerData(ob::PlannerData& data) const
{
    planner_->getPlannerData(data);
}

void InterruptiblePlanner::printProperties(std::ostream& out) const
{
    planner_->printProperties(out);
}

void InterruptiblePlanner::printSettings(std::ostream& out) const
{
    planner_->printSettings(out);
}
}  // namespace specplan::command
