// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

#include "Group.h"
#include "PoseSpace.h"

namespace specplan::test
{
namespace
{
/// An arm whose hand has to get round a pillar.
class PoseGroup : public Group
{
public:
    explicit PoseGroup(bool marksCopies)
        : Group(std::make_shared<PoseSpace>(marksCopies),
                [](const double* v) { return std::abs(v[0] - 0.1) > 0.15 || v[2] > 0.9; })
    {
    }

    /// Start and goal know their poses, as those that MoveIt makes.
    SpeculativeAStar& planWithPoses(const PlannerSettings& settings)
    {
        auto& planner = plan({-0.5, 0.8, 0.4}, {0.7, 0.8, 0.4}, settings);
        ob::ScopedState<> start = state({-0.5, 0.8, 0.4});
        ob::ScopedState<> goal = state({0.7, 0.8, 0.4});
        poses().computePose(start.get());
        poses().computePose(goal.get());
        setup.setStartAndGoalStates(start, goal);
        return planner;
    }

    [[nodiscard]] const PoseSpace& poses() const
    {
        return *static_cast<const PoseSpace*>(space.get());
    }
};

PlannerSettings fewThreads(unsigned threads)
{
    PlannerSettings settings;
    settings.numThreads = threads;
    settings.weight = 2.0;
    return settings;
}

TEST(PoseSpace, IsRefusedBeforeTheSearchWhileNobodyFillsInThePoses)
{
    for (const bool marksCopies : {true, false})
    {
        PoseGroup group(marksCopies);
        auto& planner = group.planWithPoses(fewThreads(2));
        group.setup.setup();
        group.counts.calls = 0;
        EXPECT_EQ(planner.ob::Planner::solve(20.0), ob::PlannerStatus::CRASH);
        EXPECT_FALSE(group.setup.haveSolutionPath());
        const std::string& error = planner.getReport().error;
        EXPECT_NE(error.find("a state written with the start's values is not valid"), std::string::npos) << error;
        EXPECT_NE(error.find("arm_PoseModel"), std::string::npos) << error;
        EXPECT_NE(error.find("setStateCompleter"), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
        EXPECT_LE(group.counts.calls, 3) << "the start, and two of the state that was written";
        const std::string first = error;
        EXPECT_EQ(planner.ob::Planner::solve(20.0), ob::PlannerStatus::CRASH) << "it does not become better by itself";
        EXPECT_EQ(planner.getReport().error, first);
        EXPECT_LE(group.counts.calls, 6);
    }
}

TEST(PoseSpace, IsPlannedInOnceStatesAreCompleted)
{
    for (const bool marksCopies : {true, false})
        for (const unsigned threads : {1U, 2U, 4U})
        {
            PoseGroup group(marksCopies);
            auto& planner = group.planWithPoses(fewThreads(threads));
            std::atomic<int> completed{0};
            planner.setStateCompleter(
                [&](ob::State* state)
                {
                    group.poses().computePose(state);
                    ++completed;
                });
            ASSERT_EQ(group.setup.solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(group.path().check());
            EXPECT_EQ(group.counts.stale, 0);
            EXPECT_GT(completed, 0);
            EXPECT_GT(planner.getReport().pathChecks, group.path().getStateCount());
        }
}

/// Completes states until it has been called a number of times; from then on leaves them as they are.
TEST(PoseSpace, APathWithAnIncompleteStateIsNeverCalledExact)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    int refused = 0;
    for (int until = 5; until < 400; until += 13)
    {
        PoseGroup group(true);
        auto& planner = group.planWithPoses(fewThreads(1));
        int calls = 0;
        planner.setStateCompleter(
            [&](ob::State* state)
            {
                if (++calls < until)
                    group.poses().computePose(state);
            });
        const ob::PlannerStatus status = group.setup.solve(5.0);
        if (status == ob::PlannerStatus::EXACT_SOLUTION)
        {
            EXPECT_TRUE(group.path().check()) << until;
            continue;
        }
        EXPECT_FALSE(group.setup.haveExactSolutionPath());
        if (planner.getReport().error.find("of the path found is not valid") == std::string::npos)
            continue;
        ++refused;
        EXPECT_EQ(status, ob::PlannerStatus::CRASH);
        EXPECT_NE(planner.getReport().error.find("setStateCompleter"), std::string::npos);
        const std::string error = planner.getReport().error;
        EXPECT_EQ(group.setup.solve(5.0), ob::PlannerStatus::CRASH) << "it does not become better by itself";
        EXPECT_EQ(planner.getReport().error, error);
    }
    EXPECT_GT(refused, 0);
    ompl::msg::setLogLevel(ompl::msg::LOG_INFO);
}

TEST(PoseSpace, ProvingThePathStopsWhenToldAndGoesOnLater)
{
    PoseGroup group(true);
    auto& planner = group.planWithPoses(fewThreads(1));
    planner.setStateCompleter([&](ob::State* state) { group.poses().computePose(state); });
    group.setup.setup();
    constexpr int kAnswers = 5;  ///< of the condition before it says stop
    int atMost = 0;
    int callsThatProved = 0;
    bool solved = false;
    for (int tries = 0; tries < 2000 && !solved; ++tries)
    {
        const int callsBefore = group.counts.calls;
        const bool wasProving = planner.getReport().pathChecks > 0;
        int asked = 0;
        solved = planner.solve(ob::PlannerTerminationCondition([&] { return ++asked > kAnswers; })) ==
                 ob::PlannerStatus::EXACT_SOLUTION;
        if (wasProving)
        {
            ++callsThatProved;
            atMost = std::max(atMost, group.counts.calls - callsBefore);
        }
    }
    ASSERT_TRUE(solved);
    EXPECT_GT(callsThatProved, 3) << "a few states after the other";
    EXPECT_LE(atMost, kAnswers) << "checks after the proof was told to stop";
    EXPECT_TRUE(group.path().check());
    EXPECT_GT(planner.getReport().pathChecks, group.path().getStateCount());
}
}  // namespace
}  // namespace specplan::test
