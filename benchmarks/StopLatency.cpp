// SPDX-License-Identifier: BSD-3-Clause
// How late solve() returns: 200 stops at random moments, 1 to 128 threads, checks of 5 ms and of 100 ms that sleep,
// motions with many states inside, eager and lazy. Prints the latest one of each kind and returns 1 if one was later
// than one state check and 5 ms.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <thread>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>

#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/validity/RunCheck.h"

namespace specplan::benchmarks
{
namespace
{
namespace ob = ompl::base;
using validity::steadySeconds;

constexpr double kMargin = 5e-3;
constexpr int kStops = 200;

/// \return seconds from the moment that the condition turned true to the return of solve().
double latency(unsigned threads, bool lazy, double check, double limit)
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(-1.0, 1.0);
    ompl::geometric::SimpleSetup setup(space);
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.002);  // some 35 states a motion
    setup.setStateValidityChecker(
        [check](const ob::State* state)
        {
            std::this_thread::sleep_for(std::chrono::duration<double>(check));
            const double* at = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return std::abs(std::hypot(at[0], at[1]) - 0.5) > 0.1 || (at[0] < 0.0 && std::abs(at[1]) < 0.1);
        });
    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    start[0] = start[1] = 0.0;
    goal[0] = 0.9;
    goal[1] = 0.1;
    setup.setStartAndGoalStates(start, goal);
    PlannerSettings settings;
    settings.numThreads = threads;
    settings.evaluation = lazy ? "lazy" : "eager";
    settings.spacing = {0.1};
    auto planner = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settings);
    setup.setPlanner(planner);
    setup.setup();
    const double end = steadySeconds() + limit;
    const ob::PlannerStatus status =
        planner->solve(ob::PlannerTerminationCondition([end] { return steadySeconds() >= end; }));
    return status == ob::PlannerStatus::EXACT_SOLUTION ? 0.0 : steadySeconds() - end;
}
}  // namespace

int measure()
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    constexpr unsigned kThreads[] = {1, 2, 4, 8, 16, 32, 64, 128};
    std::mt19937 random(1);
    bool late = false;
    int stops = 0;
    std::printf("%7s %8s %6s %22s\n", "threads", "check ms", "", "latest of all, ms late");
    for (const double check : {5e-3, 100e-3})
        for (const bool lazy : {false, true})
            for (const unsigned threads : kThreads)
            {
                std::uniform_real_distribution<double> moment(0.0, check < 10e-3 ? 0.2 : 0.6);
                double latest = 0.0;
                for (int i = 0; i < kStops / 32 + 1; ++i, ++stops)
                    latest = std::max(latest, latency(threads, lazy, check, moment(random)));
                std::printf("%7u %8.0f %6s %22.1f\n", threads, 1e3 * check, lazy ? "lazy" : "eager", 1e3 * latest);
                late = late || latest > check + kMargin;
            }
    std::printf("%d stops\n", stops);
    return late ? 1 : 0;
}
}  // namespace specplan::benchmarks

int main()
{
    return specplan::benchmarks::measure();
}
