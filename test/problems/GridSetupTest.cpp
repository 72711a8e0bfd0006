// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/GridSetup.h"

#include <gtest/gtest.h>

#include <cmath>

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "TemporaryFolder.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace
{
using test::complaintOf;

/// Four by three with a wall that leaves a gap at the bottom; a diagonal past its end is possible only over a corner.
GridProblem makeProblem()
{
    GridMap map(4, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x)
            map.setFree(x, y, x != 1 || y == 2);
    return {map, {0, 0}, {3, 0}};
}

double solve(GridCost cost, bool cornerCutting)
{
    const auto setup = makeGridSetup(makeProblem(), "test", cost, {});
    auto planner = std::make_shared<SpeculativeAStar>(setup->getSpaceInformation(), gridPlannerSettings(cornerCutting));
    setup->setPlanner(planner);
    setup->solve(ompl::base::plannerNonTerminatingCondition());
    EXPECT_EQ(planner->getReport().status, "solved");
    EXPECT_TRUE(setup->getSolutionPath().check());
    return planner->getReport().cost;
}

TEST(GridSetup, CostsOfAllKindsWithAndWithoutCornerCutting)
{
    // Without: down 2, right 2, up by one diagonal and one straight move. With: down 1, then three diagonals.
    EXPECT_NEAR(solve(GridCost::Length, false), 5.0 + std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(solve(GridCost::Length, true), 1.0 + 3.0 * std::sqrt(2.0), 1e-12);
    EXPECT_EQ(solve(GridCost::Steps, false), 6.0);
    EXPECT_EQ(solve(GridCost::Steps, true), 4.0);
    EXPECT_EQ(solve(GridCost::Seed, true), 4.0);
}

TEST(GridSetup, RefusesStartsAndGoalsThatAreNotFree)
{
    GridProblem problem = makeProblem();
    problem.start = {1, 0};
    const auto make = [&problem] { (void)makeGridSetup(problem, "m.map", GridCost::Length, {}); };
    EXPECT_EQ(complaintOf<InputError>(make), "m.map: expected a free start cell, but start 1,0 is an obstacle");
    problem = makeProblem();
    problem.goal = {4, 0};
    EXPECT_EQ(complaintOf<InputError>(make), "m.map: expected a goal inside the map of 4 x 3 cells, found goal 4,0");
    problem.goal = {0, -1};
    EXPECT_EQ(complaintOf<InputError>(make), "m.map: expected a goal inside the map of 4 x 3 cells, found goal 0,-1");
}

TEST(GridSetup, SolvesAMapOfOneCell)
{
    GridMap map(1, 1);
    map.setFree(0, 0, true);
    const auto setup = makeGridSetup({map, {0, 0}, {0, 0}}, "one", GridCost::Length, {});
    setup->setPlanner(std::make_shared<SpeculativeAStar>(setup->getSpaceInformation(), gridPlannerSettings(false)));
    EXPECT_EQ(setup->solve(ompl::base::plannerNonTerminatingCondition()), ompl::base::PlannerStatus::EXACT_SOLUTION);
}
}  // namespace
}  // namespace specplan::problems
