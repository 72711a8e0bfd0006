// SPDX-License-Identifier: BSD-3-Clause
// Which states the checks of motions look at: none of them twice.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <utility>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Solves with one thread, and counts the calls for each state; those for start and goal are left out.
template <typename Values, typename ValuesOf>
std::map<Values, int> callsByState(const ob::StateSpacePtr& space, const ob::ScopedState<>& start,
                                   const ob::ScopedState<>& goal, const PlannerSettings& settings, double resolution,
                                   const ValuesOf& valuesOf)
{
    std::map<Values, int> calls;
    og::SimpleSetup setup(space);
    setup.getSpaceInformation()->setStateValidityCheckingResolution(resolution);
    setup.setStateValidityChecker(
        [&](const ob::State* state)
        {
            ++calls[valuesOf(state)];
            return true;
        });
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settings));
    EXPECT_EQ(setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    const std::map<Values, int> inSolve = calls;
    EXPECT_TRUE(setup.getSolutionPath().check());
    return inSolve;
}

template <typename Values>
int repeats(const std::map<Values, int>& calls)
{
    int count = 0;
    for (const auto& [values, times] : calls)
        count += times - 1;
    return count;
}

TEST(MotionStates, AStepOfADiscreteSpaceHasNoneThatAreNotItsEnds)
{
    const auto space = std::make_shared<ob::DiscreteStateSpace>(0, 30);
    ob::ScopedState<ob::DiscreteStateSpace> start(space);
    ob::ScopedState<ob::DiscreteStateSpace> goal(space);
    start->value = 3;
    goal->value = 20;
    PlannerSettings settings;
    settings.numThreads = 1;
    for (const char* evaluation : {"eager", "lazy"})
    {
        settings.evaluation = evaluation;
        const std::map<int, int> calls = callsByState<int>(
            space, ob::ScopedState<>(start), ob::ScopedState<>(goal), settings, 0.01,
            [](const ob::State* state) { return state->as<ob::DiscreteStateSpace::StateType>()->value; });
        EXPECT_GE(calls.size(), 18U);
        EXPECT_LE(repeats(calls), 2) << evaluation << ": start and goal are looked at when they are taken";
    }
}

TEST(MotionStates, DiscreteStepsBesideOthersRepeatNothing)
{
    auto space = std::make_shared<ob::CompoundStateSpace>();
    auto line = std::make_shared<ob::RealVectorStateSpace>(1);
    line->setBounds(0.0, 1.0);
    space->addSubspace(line, 1.0);
    space->addSubspace(std::make_shared<ob::DiscreteStateSpace>(0, 5), 1.0);
    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    const auto set = [](ob::ScopedState<>& state, double x, int number)
    {
        auto* parts = state.get()->as<ob::CompoundState>();
        parts->as<ob::RealVectorStateSpace::StateType>(0)->values[0] = x;
        parts->as<ob::DiscreteStateSpace::StateType>(1)->value = number;
    };
    set(start, 0.0, 0);
    set(goal, 0.5, 4);
    PlannerSettings settings;
    settings.numThreads = 1;
    settings.spacing = {0.25, 1.0};
    const auto calls = callsByState<std::pair<double, int>>(
        space, start, goal, settings, 0.01,
        [](const ob::State* state)
        {
            const auto* parts = state->as<ob::CompoundState>();
            return std::pair(parts->as<ob::RealVectorStateSpace::StateType>(0)->values[0],
                             parts->as<ob::DiscreteStateSpace::StateType>(1)->value);
        });
    EXPECT_GT(calls.size(), 30U);
    EXPECT_LE(repeats(calls), 2) << "start and goal";
}

TEST(MotionStates, WhatAGlanceHasSeenIsNotLookedAtAgain)
{
    const auto space = std::make_shared<ob::RealVectorStateSpace>(1);
    space->setBounds(0.0, 1.0);
    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    start[0] = 0.0;
    goal[0] = 1.0;
    PlannerSettings settings;
    settings.numThreads = 1;
    settings.evaluation = "lazy";
    settings.anytime = false;
    settings.spacing = {0.125};
    const std::map<double, int> calls = callsByState<double>(
        space, start, goal, settings, 0.001,
        [](const ob::State* state) { return state->as<ob::RealVectorStateSpace::StateType>()->values[0]; });
    EXPECT_GT(calls.size(), 900U);
    EXPECT_LE(repeats(calls), 2) << "start and goal";
}
}  // namespace
}  // namespace specplan::test
