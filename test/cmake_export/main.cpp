// SPDX-License-Identifier: BSD-3-Clause
// A user's program: plans around a disc in the unit square.
#include <cmath>
#include <iostream>
#include <memory>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include <specplan/planner/SpeculativeAStar.h>
#include <specplan/planner/TestChecker.h>

namespace ob = ompl::base;

int main()
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0.0, 1.0);
    ompl::geometric::SimpleSetup setup(space);
    setup.setStateValidityChecker(
        [](const ob::State* state)
        {
            const double* point = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return std::hypot(point[0] - 0.5, point[1] - 0.5) > 0.3;
        });

    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    start[0] = start[1] = 0.1;
    goal[0] = goal[1] = 0.9;
    setup.setStartAndGoalStates(start, goal);

    const specplan::CheckerReport report = specplan::testChecker(setup.getSpaceInformation());
    std::cout << report;
    if (!report.passed())
        return 1;

    setup.setPlanner(std::make_shared<specplan::SpeculativeAStar>(setup.getSpaceInformation()));
    const ob::PlannerStatus status = setup.solve(10.0);
    std::cout << status.asString() << '\n';
    return status == ob::PlannerStatus::EXACT_SOLUTION ? 0 : 1;
}
