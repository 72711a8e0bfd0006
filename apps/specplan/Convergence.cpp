// SPDX-License-Identifier: BSD-3-Clause
#include "Convergence.h"

#include <cmath>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "specplan/problems/TextFile.h"

namespace specplan::command
{
namespace ob = ompl::base;

Convergence::Convergence(const ob::Planner& planner)
{
    for (const auto& [name, read] : planner.getPlannerProgressProperties())
        if (name == "best cost REAL" || name == "best cost DOUBLE")  // the latter from BIT*
            bestCost_ = read;
}

void Convergence::begin()
{
    points_.clear();
    begin_ = Clock::now();
    next_ = 0.0;
}

double Convergence::elapsed() const
{
    return std::chrono::duration<double>(Clock::now() - begin_).count();
}

void Convergence::add(double cost)
{
    if (std::isfinite(cost) && (points_.empty() || cost < points_.back().cost))
        points_.push_back({elapsed(), cost});
}

void Convergence::look()
{
    const double now = elapsed();
    if (!bestCost_ || now < next_)
        return;
    next_ = now + kInterval;
    if (double cost = 0.0; problems::parse(bestCost_(), cost))
        add(cost);
}

void Convergence::end(const ob::ProblemDefinition& problem)
{
    if (!problem.hasExactSolution())
    {
        points_.clear();
        return;
    }
    const ob::OptimizationObjectivePtr objective =
        problem.hasOptimizationObjective()
            ? problem.getOptimizationObjective()
            : std::make_shared<ob::PathLengthOptimizationObjective>(problem.getSpaceInformation());
    add(problem.getSolutionPath()->cost(objective).value());
}
}  // namespace specplan::command
