// SPDX-License-Identifier: BSD-3-Clause
// Every way a call of solve() can end.
#include <gtest/gtest.h>

#include <ompl/base/goals/GoalRegion.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Exception.h>

#include "Scene.h"
#include "specplan/planner/OmplCompat.h"

namespace specplan::test
{
namespace
{
TEST(Status, AWallWithoutAGapIsInfeasibleNotATimeOut)
{
    for (const unsigned threads : {1U, 4U})
    {
        Scene scene;
        scene.closed = true;
        scene.plan(settingsFor(threads));
        EXPECT_EQ(scene.solve(), planner::kInfeasible);
        EXPECT_EQ(scene.planner->getReport().status, "infeasible");
        EXPECT_FALSE(scene.setup.getProblemDefinition()->hasSolution());
        EXPECT_EQ(scene.solve(), planner::kInfeasible);
    }
}

TEST(Status, InvalidStartsAndGoalsAreNamed)
{
    Scene inWall;
    inWall.start = {{0.5, 0.5}};
    inWall.plan(settingsFor(2));
    EXPECT_EQ(inWall.solve(), ob::PlannerStatus::INVALID_START);

    Scene outside;
    outside.start = {{1.5, 0.5}};
    outside.plan(settingsFor(2));
    EXPECT_EQ(outside.solve(), ob::PlannerStatus::INVALID_START);

    Scene goalInWall;
    goalInWall.goals = {{0.5, 0.5}};
    goalInWall.plan(settingsFor(2));
    EXPECT_EQ(goalInWall.solve(0.2), ob::PlannerStatus::INVALID_GOAL);
    EXPECT_EQ(goalInWall.planner->getReport().status, "invalid goal");
}

/// A goal that can only be recognised.
class Predicate : public ob::GoalRegion
{
public:
    explicit Predicate(const ob::SpaceInformationPtr& si) : ob::GoalRegion(si)
    {
        setThreshold(0.1);
    }

    double distanceGoal(const ob::State* state) const override
    {
        return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
    }
};

TEST(Status, AGoalThatCanOnlyBeRecognisedIsReached)
{
    Scene scene;
    scene.plan(settingsFor(1));
    scene.setup.setGoal(std::make_shared<Predicate>(scene.setup.getSpaceInformation()));
    scene.planner->clear();
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(scene.setup.getGoal()->isSatisfied(scene.path().getStates().back()));
}

TEST(Status, OtherStateSpacesAndMissingBoundsAreRefused)
{
    auto se2 = std::make_shared<ob::SE2StateSpace>();
    se2->setBounds(ob::RealVectorBounds(2));
    og::SimpleSetup setup(se2);
    setup.setStateValidityChecker([](const ob::State*) { return true; });
    ob::ScopedState<> state(se2);
    state.random();
    setup.setStartAndGoalStates(state, state);
    SpeculativeAStar planner(setup.getSpaceInformation());
    planner.setProblemDefinition(setup.getProblemDefinition());
    EXPECT_THROW((void)planner.solve(0.1), ompl::Exception);
}

TEST(Status, AnExceptionOfANeededCheckIsACrashWithItsMessageOrIsRethrown)
{
    std::uint64_t sequentialHash = 0;
    for (const unsigned threads : {1U, 2U, 8U})
    {
        Scene scene;
        scene.throwIf = [](const double* x) { return x[0] > 0.3 && x[0] < 0.32; };
        PlannerSettings settings = settingsFor(threads);
        scene.plan(settings);
        scene.freeze();
        EXPECT_EQ(scene.solve(), ob::PlannerStatus::CRASH);
        EXPECT_EQ(scene.planner->getReport().status, "crash");
        EXPECT_EQ(scene.planner->getReport().error, "the checker lost its mind");
        if (threads == 1)
            sequentialHash = scene.planner->getReport().orderHash;
        EXPECT_EQ(scene.planner->getReport().orderHash, sequentialHash);

        settings.rethrowExceptions = true;
        scene.planner->setSettings(settings);
        EXPECT_THROW((void)scene.solve(), std::runtime_error);
        --scene.solving;
        EXPECT_EQ(scene.callsOutside, 0);

        scene.throwIf = nullptr;
        EXPECT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    }
}

TEST(Status, SlowChecksDoNotHoldUpATimeLimit)
{
    for (const unsigned threads : {1U, 2U})
    {
        Scene scene;
        scene.plan(settingsFor(threads));
        scene.latency = std::chrono::milliseconds(60);
        std::atomic<int> callsAtEnd{0};
        std::atomic<bool> over{false};
        std::thread alarm(
            [&]
            {
                std::this_thread::sleep_for(std::chrono::milliseconds(200));
                callsAtEnd = scene.calls.load();
                over = true;
            });
        (void)scene.solve(ob::PlannerTerminationCondition([&] { return over.load(); }));
        alarm.join();
        // Whatever ran at the end was allowed to finish; nothing more than one check for each worker began after it.
        EXPECT_LE(scene.calls.load(), callsAtEnd.load() + static_cast<int>(threads));
    }
}
}  // namespace
}  // namespace specplan::test
