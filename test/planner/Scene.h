// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

/// The unit cube of some dimension with a wall across the first axis that has a gap along the second; counts its
/// checker's calls.
class Scene
{
public:
    explicit Scene(unsigned dimension = 2) : space(std::make_shared<ob::RealVectorStateSpace>(dimension)), setup(space)
    {
        space->setBounds(0.0, 1.0);
        setup.setStateValidityChecker([this](const ob::State* state) { return isValid(state); });
        start = {std::vector<double>(dimension, 0.1)};
        goals = {std::vector<double>(dimension, 0.9)};
    }

    /// Puts start and goal into the problem and makes the planner.
    specplan::SpeculativeAStar& plan(const PlannerSettings& settings)
    {
        setup.clearStartStates();
        for (const auto& values : start)
            setup.addStartState(state(values));
        auto goal = std::make_shared<ob::GoalStates>(setup.getSpaceInformation());
        for (const auto& values : goals)
            goal->addState(state(values));
        setup.setGoal(goal);
        auto made = std::make_shared<specplan::SpeculativeAStar>(setup.getSpaceInformation(), settings);
        setup.setPlanner(made);
        setup.setup();
        planner = made.get();
        return *planner;
    }

    ob::ScopedState<> state(const std::vector<double>& values) const
    {
        ob::ScopedState<> made(setup.getStateSpace());
        for (std::size_t axis = 0; axis < values.size(); ++axis)
            made[static_cast<unsigned>(axis)] = values[axis];
        return made;
    }

    bool isValid(const ob::State* state)
    {
        ++calls;
        if (solving.load() == 0)
            ++callsOutside;
        const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
        if (latency.count() > 0)
            std::this_thread::sleep_for(latency);
        if (throwIf && throwIf(x))
            throw std::runtime_error("the checker lost its mind");
        if (closed)
            return std::abs(x[0] - 0.5) > 0.05;
        return std::abs(x[0] - 0.5) > 0.05 || x[1] > 0.8;
    }

    ob::PlannerStatus solve(double seconds = 20.0)
    {
        return solve(ob::timedPlannerTerminationCondition(seconds));
    }

    ob::PlannerStatus solve(const ob::PlannerTerminationCondition& ptc)
    {
        ++solving;
        const ob::PlannerStatus status = planner->solve(ptc);
        --solving;
        return status;
    }

    og::PathGeometric& path()
    {
        return *setup.getProblemDefinition()->getSolutionPath()->as<og::PathGeometric>();
    }

    std::vector<double> values(const ob::State* state) const
    {
        std::vector<double> reals;
        space->copyToReals(reals, state);
        return reals;
    }

    std::shared_ptr<ob::RealVectorStateSpace> space;
    og::SimpleSetup setup;
    std::vector<std::vector<double>> start;
    std::vector<std::vector<double>> goals;
    specplan::SpeculativeAStar* planner = nullptr;
    std::atomic<int> calls{0};
    std::atomic<int> callsOutside{0};
    std::atomic<int> solving{1};  ///< 1 outside of solve(): setting up may check states; see freeze()
    std::chrono::microseconds latency{0};
    std::function<bool(const double*)> throwIf;
    bool closed = false;  ///< no gap in the wall

    /// From now on every call outside of solve() counts as an offence.
    void freeze()
    {
        solving = 0;
        callsOutside = 0;
    }
};

inline PlannerSettings settingsFor(unsigned threads, const std::string& policy = "direction",
                                   const std::string& executor = "threads")
{
    PlannerSettings settings;
    settings.numThreads = threads;
    settings.speculationPolicy = policy;
    settings.executor = executor;
    return settings;
}
}  // namespace specplan::test
