// SPDX-License-Identifier: BSD-3-Clause
// Drop-in use: an ordinary OMPL set-up, and one line that names the planner.
#include <chrono>
#include <cmath>
#include <iostream>
#include <thread>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include <specplan/planner/SpeculativeAStar.h>

namespace ob = ompl::base;
namespace og = ompl::geometric;

// A ring with a gap on its left; each check takes a millisecond, as one against meshes or a simulator might.
bool isValid(const ob::State* state)
{
    const double* xy = state->as<ob::RealVectorStateSpace::StateType>()->values;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const bool onRing = std::abs(std::hypot(xy[0], xy[1]) - 0.5) < 0.1;
    return !onRing || (xy[0] < 0.0 && std::abs(xy[1]) < 0.1);
}

int main()
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(-1.0, 1.0);

    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(isValid);
    ob::ScopedState<> start(space), goal(space);
    start[0] = start[1] = 0.0;
    goal[0] = 0.9;
    goal[1] = 0.1;
    setup.setStartAndGoalStates(start, goal);

    auto planner = std::make_shared<specplan::SpeculativeAStar>(setup.getSpaceInformation());
    planner->params().setParam("num_threads", "16");
    setup.setPlanner(planner);  // the one line that changes

    const ob::PlannerStatus status = setup.solve(30.0);
    const specplan::SearchReport& report = planner->getReport();
    std::cout << status.asString() << ", length " << setup.getSolutionPath().length() << ", " << report.checksUsed
              << " checks needed, " << report.wallTime << " s: " << report.speedup
              << " times as fast as sequential A*\n";
    return status == ob::PlannerStatus::EXACT_SOLUTION ? 0 : 1;
}
