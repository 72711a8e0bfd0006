// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <utility>
#include <vector>

#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include "NotingChecker.h"
#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace og = ompl::geometric;

/// A planning group as MoveIt sets it up: a space of its own class, a checker that writes into states.
class Group
{
public:
    using State = std::vector<double>;

    explicit Group(
        std::shared_ptr<GroupSpace> ofGroup, NotingChecker::Truth truth = [](const double*) { return true; },
        std::chrono::microseconds latency = std::chrono::microseconds(0))
        : space(std::move(ofGroup)), setup(space)
    {
        setup.setStateValidityChecker(
            std::make_shared<NotingChecker>(setup.getSpaceInformation(), std::move(truth), counts, latency));
    }

    explicit Group(
        std::vector<Joint> joints, NotingChecker::Truth truth = [](const double*) { return true; },
        std::chrono::microseconds latency = std::chrono::microseconds(0))
        : Group(std::make_shared<GroupSpace>(std::move(joints)), std::move(truth), latency)
    {
    }

    [[nodiscard]] ob::ScopedState<> state(const State& values) const
    {
        ob::ScopedState<> made(space);
        std::copy(values.begin(), values.end(), GroupSpace::valuesOf(made.get()));
        return made;
    }

    SpeculativeAStar& plan(const State& start, const State& goal, const PlannerSettings& settings = {})
    {
        setup.setStartAndGoalStates(state(start), state(goal));
        auto made = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settings);
        setup.setPlanner(made);
        return *made;
    }

    [[nodiscard]] og::PathGeometric& path() const
    {
        return *setup.getProblemDefinition()->getSolutionPath()->as<og::PathGeometric>();
    }

    [[nodiscard]] State values(const ob::State* state) const
    {
        return {GroupSpace::valuesOf(state), GroupSpace::valuesOf(state) + space->count()};
    }

    std::shared_ptr<GroupSpace> space;
    mutable og::SimpleSetup setup;
    NotingChecker::Counts counts;
};
}  // namespace specplan::test
