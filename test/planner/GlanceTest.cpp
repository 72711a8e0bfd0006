// SPDX-License-Identifier: BSD-3-Clause
// Glances at long motions: what they look at, and what that saves.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <map>
#include <vector>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/CheckTrace.h"
#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

/// A unit square with a wall, far thinner than a step of the lattice, that ends at y = 0.8.
struct ThinWall
{
    explicit ThinWall(const std::string& evaluation, double resolution)
        : setup(std::make_shared<ob::RealVectorStateSpace>(2))
    {
        setup.getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(0.0, 1.0);
        setup.getSpaceInformation()->setStateValidityCheckingResolution(resolution);
        setup.setStateValidityChecker(
            [this](const ob::State* state)
            {
                ++states;
                const auto* at = state->as<ob::RealVectorStateSpace::StateType>();
                return at->values[1] > 0.8 || std::abs(at->values[0] - 0.51) > 0.004;
            });
        setup.setOptimizationObjective(
            std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation()));
        ob::ScopedState<> start(setup.getStateSpace());
        ob::ScopedState<> goal(setup.getStateSpace());
        start[0] = 0.1;
        start[1] = 0.3;
        goal[0] = 0.9;
        goal[1] = 0.3;
        setup.setStartAndGoalStates(start, goal);
        planner = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation());
        setup.setPlanner(planner);
        planner->params().setParam("evaluation", evaluation);
        planner->params().setParam("resolution", "0.04");
        planner->params().setParam("anytime", "0");
        planner->params().setParam("num_threads", "1");
        planner->setCheckTrace(std::make_shared<planner::CheckTrace>());
    }

    std::atomic<int> states{0};
    og::SimpleSetup setup;
    std::shared_ptr<SpeculativeAStar> planner;
};

TEST(Glance, SparesLongMotionsThatAreInvalidAndMostStates)
{
    ThinWall eager("eager", 0.0002);
    ThinWall lazy("lazy", 0.0002);
    ASSERT_EQ(eager.setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    ASSERT_EQ(lazy.setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_NEAR(lazy.setup.getSolutionPath().length(), eager.setup.getSolutionPath().length(), 1e-9);
    const int states = lazy.states;
    EXPECT_TRUE(lazy.setup.getSolutionPath().check());
    EXPECT_LT(5 * states, eager.states);

    using Ends = std::vector<double>;
    std::map<Ends, bool> seen;  // what glances told, by both ends
    int glances = 0;
    int checkedInVain = 0;
    lazy.planner->visitChecks(
        [&](const SpeculativeAStar::CheckRun& check)
        {
            if (check.to == nullptr)
                return;
            Ends ends;
            for (const ob::State* state : {check.from, check.to})
                for (const int axis : {0, 1})
                    ends.push_back(state->as<ob::RealVectorStateSpace::StateType>()->values[axis]);
            if (check.glance)
            {
                ++glances;
                EXPECT_TRUE(seen.emplace(ends, check.valid).second) << "one glance a motion";
                return;
            }
            const auto told = seen.find(ends);
            EXPECT_TRUE(told == seen.end() || told->second) << "a motion that a glance refused was checked";
            checkedInVain += check.valid ? 0 : 1;
        });
    EXPECT_GT(glances, 20);
    EXPECT_LE(checkedInVain, 2) << "the wall is thicker than the gaps between what a glance looks at, but for its end";
}

TEST(Glance, IsNotTakenOfShortMotions)
{
    ThinWall lazy("lazy", 0.004);  // some ten states a motion
    ASSERT_EQ(lazy.setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    lazy.planner->visitChecks([](const SpeculativeAStar::CheckRun& check) { EXPECT_FALSE(check.glance); });
}
}  // namespace
}  // namespace specplan::test
