// SPDX-License-Identifier: BSD-3-Clause
// OMPL's life cycle: setup, solve, solve again, clear, in every order that OMPL's own programs use.
#include <gtest/gtest.h>

#include <ompl/base/PlannerData.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/Exception.h>

#include "Scene.h"
#include "specplan/planner/OmplCompat.h"

namespace specplan::test
{
namespace
{
class LifeCycle : public testing::TestWithParam<unsigned>
{
};

INSTANTIATE_TEST_SUITE_P(Threads, LifeCycle, testing::Values(1U, 2U, 8U));

TEST_P(LifeCycle, SolveClearSolveGivesTheSameAnswer)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const double length = scene.path().length();
    const std::uint64_t hash = scene.planner->getReport().orderHash;
    EXPECT_TRUE(scene.path().check());
    for (int round = 0; round < 3; ++round)
    {
        scene.setup.clear();
        ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(scene.path().length(), length);
        EXPECT_EQ(scene.planner->getReport().orderHash, hash);
    }
    scene.planner->clear();
    scene.planner->clear();
    scene.planner->clear();
}

TEST_P(LifeCycle, SolvingAgainStillSaysSolvedAndChecksNothing)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const int calls = scene.calls;
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.calls, calls);
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(scene.setup.haveExactSolutionPath());
    EXPECT_EQ(scene.calls, calls);
}

/// Without an objective nobody asks for the best path, which takes longer.
PlannerSettings optimal(unsigned threads)
{
    PlannerSettings settings = settingsFor(threads);
    settings.weight = 1.0;
    return settings;
}

TEST_P(LifeCycle, AlwaysTrueConditionAndZeroBudgetExpandNothingAndTheSearchGoesOn)
{
    Scene whole;
    whole.plan(optimal(1));
    ASSERT_EQ(whole.solve(), ob::PlannerStatus::EXACT_SOLUTION);

    Scene scene;
    scene.plan(optimal(GetParam()));
    EXPECT_EQ(scene.solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(scene.planner->getReport().expansions, 0U);
    EXPECT_EQ(scene.solve(0.0), ob::PlannerStatus::TIMEOUT);
    int solves = 0;
    ob::PlannerStatus status;
    do
    {
        int asked = 0;
        status = scene.solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 40; }));
        EXPECT_LE(asked, 42);
    } while (status != ob::PlannerStatus::EXACT_SOLUTION && ++solves < 1000);
    EXPECT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GT(solves, 2);
    EXPECT_EQ(scene.planner->getReport().orderHash, whole.planner->getReport().orderHash);
    EXPECT_EQ(scene.planner->getReport().checksUsed, whole.planner->getReport().checksUsed);
}

TEST_P(LifeCycle, ATimeOutGivesAnApproximateSolutionWithTheTrueDifference)
{
    std::vector<double> sequentialEnd;
    for (const unsigned threads : {1U, GetParam()})
    {
        Scene scene;
        scene.plan(optimal(threads));
        int asked = 0;
        ASSERT_EQ(scene.solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 200; })),
                  ob::PlannerStatus::APPROXIMATE_SOLUTION);
        const auto& pdef = *scene.setup.getProblemDefinition();
        EXPECT_TRUE(pdef.hasApproximateSolution());
        EXPECT_FALSE(pdef.hasExactSolution());
        EXPECT_TRUE(scene.path().check());
        EXPECT_EQ(scene.values(scene.path().getState(0)), scene.start.front());
        const ob::State* end = scene.path().getStates().back();
        EXPECT_DOUBLE_EQ(pdef.getSolutionDifference(), scene.space->distance(end, scene.state(scene.goals[0]).get()));
        if (threads == 1)
            sequentialEnd = scene.values(end);
        EXPECT_EQ(scene.values(end), sequentialEnd);
    }
}

TEST_P(LifeCycle, NothingIsCheckedOutsideSolveAndNeverTwice)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    scene.latency = std::chrono::microseconds(50);
    scene.freeze();
    int asked = 0;
    (void)scene.solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 30; }));
    const int calls = scene.calls;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(scene.calls, calls) << "a check ran after solve() had returned";
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerData data(scene.setup.getSpaceInformation());
    scene.planner->getPlannerData(data);
    scene.planner->clear();
    EXPECT_EQ(scene.callsOutside, 0);
}

TEST_P(LifeCycle, AChangedCheckerLeavesNoStaleAnswer)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GT(scene.path().length(), 1.3);
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    scene.setup.setStateValidityChecker([](const ob::State*) { return true; });
    scene.setup.getSpaceInformation()->setup();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_NEAR(scene.path().length(), 0.8 * std::sqrt(2.0), 0.02);
}

TEST_P(LifeCycle, ChangedSettingsTakeEffectWithTheNextSolve)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const auto nodes = scene.planner->getReport().nodes;
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    ASSERT_TRUE(scene.planner->params().setParam("resolution", "0.05"));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_LT(scene.planner->getReport().nodes, nodes / 2);
    EXPECT_TRUE(scene.path().check());
}

TEST_P(LifeCycle, TheNumberOfThreadsMayChangeBetweenSetupAndSolve)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    scene.planner->setup();
    for (const char* threads : {"3", "1", "2"})
    {
        ASSERT_TRUE(scene.planner->params().setParam("num_threads", threads));
        ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(std::to_string(scene.planner->getReport().threads), threads);
        ASSERT_TRUE(scene.planner->params().setParam("num_threads", "4"));
        scene.planner->setup();
        scene.setup.getProblemDefinition()->clearSolutionPaths();
    }
}

TEST_P(LifeCycle, ClearQueryTakesANewProblem)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    scene.setup.getProblemDefinition()->clearStartStates();
    scene.setup.addStartState(scene.state({0.2, 0.7}));
    scene.setup.getProblemDefinition()->clearGoal();
    scene.setup.setGoalState(scene.state({0.2, 0.3}));
    scene.planner->clearQuery();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    // The lattice is still that of the first query, and start and goal lie a little off it.
    EXPECT_NEAR(scene.path().length(), 0.4, 0.01);
    EXPECT_EQ(scene.values(scene.path().getState(0)), (std::vector<double>{0.2, 0.7}));
}

TEST_P(LifeCycle, StartsAndGoalsAddedLaterEnterTheSearch)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    int asked = 0;
    (void)scene.solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 20; }));
    const auto goal = std::static_pointer_cast<ob::GoalStates>(scene.setup.getGoal());
    goal->addState(scene.state({0.13, 0.22}));
    scene.setup.addStartState(scene.state({0.15, 0.2}));
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.values(scene.path().getState(0)), (std::vector<double>{0.15, 0.2}));
    EXPECT_EQ(scene.values(scene.path().getStates().back()), (std::vector<double>{0.13, 0.22}));
    EXPECT_TRUE(scene.path().check());
}

TEST_P(LifeCycle, TwoPlannersInOneProcessDoNotDisturbEachOther)
{
    Scene one;
    Scene two(3);
    one.plan(settingsFor(GetParam()));
    two.plan(settingsFor(GetParam()));
    one.latency = two.latency = std::chrono::microseconds(20);
    ob::PlannerStatus first;
    std::thread other([&] { first = one.solve(); });
    const ob::PlannerStatus second = two.solve();
    other.join();
    EXPECT_EQ(first, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(second, ob::PlannerStatus::EXACT_SOLUTION);
    Scene alone;
    alone.plan(settingsFor(1));
    ASSERT_EQ(alone.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(one.planner->getReport().orderHash, alone.planner->getReport().orderHash);
}

TEST_P(LifeCycle, PlannerDataHoldsTheSearchTree)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerData data(scene.setup.getSpaceInformation());
    scene.planner->getPlannerData(data);
    EXPECT_EQ(data.numStartVertices(), 1U);
    EXPECT_EQ(data.numGoalVertices(), 1U);
    EXPECT_GT(data.numVertices(), scene.path().getStateCount());
    EXPECT_EQ(data.numEdges(), data.numVertices() - 1);
    EXPECT_EQ(data.properties.count("expansions INTEGER"), 1U);
    data.decoupleFromPlanner();
}

TEST(Benchmark, RunsWithProgressPropertiesAndCountsEveryRunAsSolved)
{
    Scene scene;
    scene.plan(settingsFor(4));
    scene.latency = std::chrono::microseconds(20);
    ompl::tools::Benchmark benchmark(scene.setup, "specplan");
    benchmark.addPlanner(std::make_shared<SpeculativeAStar>(scene.setup.getSpaceInformation(), settingsFor(4)));
    ompl::tools::Benchmark::Request request(10.0, 1000.0, 3, 0.01, false, false);
    benchmark.benchmark(request);
    const auto& runs = benchmark.getRecordedExperimentData().planners.at(0).runs;
    ASSERT_EQ(runs.size(), 3U);
    for (const auto& run : runs)
    {
        EXPECT_EQ(run.at("solved BOOLEAN"), "1");
        EXPECT_EQ(run.count("checks used INTEGER"), 1U);
    }
}

TEST(Setup, WorksBeforeAProblemExists)
{
    Scene scene;
    SpeculativeAStar planner(scene.setup.getSpaceInformation());
    planner.setup();
    planner.clear();
    planner.clearQuery();
    EXPECT_THROW((void)planner.solve(0.1), ompl::Exception);
}
}  // namespace
}  // namespace specplan::test
