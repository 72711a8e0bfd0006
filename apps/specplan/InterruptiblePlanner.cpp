// SPDX-License-Identifier: BSD-3-Clause
#include "InterruptiblePlanner.h"

#include <exception>
#include <thread>
#include <utility>

#include <ompl/config.h>
#include <ompl/util/Exception.h>

#include "Interrupt.h"

namespace specplan::command
{
namespace ob = ompl::base;

namespace
{
/// Benchmark reads these properties from another thread while the planner runs. Before OMPL 1.6 two of BIT*'s walk over
/// its graph as it changes, which now and then ends the program (ompl/ompl#779).
bool isSafeToPoll([[maybe_unused]] const std::string& property)
{
#if OMPL_VERSION_VALUE < 1006000
    return property != "current free states INTEGER" && property != "current graph vertices INTEGER";
#else
    return true;
#endif
}
}  // namespace

InterruptiblePlanner::InterruptiblePlanner(ob::PlannerPtr planner, std::shared_ptr<const CountingChecker> checker)
    : ob::Planner(planner->getSpaceInformation(), planner->getName()),
      planner_(std::move(planner)),
      checker_(std::move(checker)),
      convergence_(*planner_)
{
    specs_ = planner_->getSpecs();
    params_.include(planner_->params());
    for (const auto& [name, read] : planner_->getPlannerProgressProperties())
        if (isSafeToPoll(name))
            addPlannerProgressProperty(name, read);
}

ob::PlannerStatus InterruptiblePlanner::solve(const ob::PlannerTerminationCondition& ptc)
{
    const std::uint64_t before = checker_->calls();
    ob::PlannerStatus status = ob::PlannerStatus::CRASH;
    const std::thread::id here = std::this_thread::get_id();
    convergence_.begin();
    try
    {
        status = planner_->solve(ob::PlannerTerminationCondition(
            [&]
            {
                if (std::this_thread::get_id() == here)  // some planners ask in several
                    convergence_.look();
                return ptc() || interrupted();
            }));
    }
    catch (const std::exception& error)
    {
        throw ompl::Exception(error.what());
    }
    checks_ = checker_->calls() - before;
    convergence_.end(*pdef_);
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
