// SPDX-License-Identifier: BSD-3-Clause
// Goals as MoveIt hands them over: sampled by a thread of their own, some time after the search has begun.
#include <chrono>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "GoalUnion.h"
#include "Group.h"

namespace specplan::test
{
namespace
{
using namespace std::chrono_literals;

/// A group with goals that come up late.
class LateGoals : public ::testing::Test
{
protected:
    LateGoals()
        : group({{Joint::Kind::Revolute, 2.0}, {Joint::Kind::Revolute, 2.0}},
                [](const double* v) { return std::abs(v[0] - 1.0) > 0.2 || v[1] > 1.0; })
    {
    }

    ~LateGoals() override
    {
        for (const auto& goal : goals)
            goal->stopSampling();
    }

    /// One constraint: so many states, one after the other.
    std::shared_ptr<ob::GoalLazySamples> constraint(double at, int count, std::chrono::milliseconds delay)
    {
        const auto sampler =
            [this, at, count, delay, made = std::make_shared<int>(0)](const ob::GoalLazySamples* goal, ob::State* state)
        {
            if (*made >= count)
                return false;
            for (auto waited = 0ms; waited < delay && goal->isSampling(); waited += 5ms)
                std::this_thread::sleep_for(5ms);
            for (std::size_t i = 0; i < group.space->count(); ++i)
                GroupSpace::valuesOf(state)[i] = at + 0.1 * *made;
            state->as<GroupSpace::StateType>()->flags = 0;
            ++*made;
            return group.setup.getSpaceInformation()->isValid(state);
        };
        goals.push_back(std::make_shared<ob::GoalLazySamples>(group.setup.getSpaceInformation(), sampler, false));
        return goals.back();
    }

    void solveTo(const ob::GoalPtr& goal)
    {
        PlannerSettings settings;
        settings.numThreads = 2;
        group.plan({-0.5, 0.1}, {0.0, 0.0}, settings);
        group.setup.setGoal(goal);
        group.setup.setup();
        for (const auto& each : goals)
            each->startSampling();
        ASSERT_EQ(group.setup.solve(30.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(group.path().check());
        EXPECT_TRUE(goal->isSatisfied(group.path().getStates().back()));
        EXPECT_EQ(group.counts.stale, 0);
    }

    Group group;
    GoalUnion::Goals goals;
};

TEST_F(LateGoals, OfOneConstraintAreWaitedFor)
{
    solveTo(constraint(1.4, 3, 50ms));
}

TEST_F(LateGoals, OfSeveralConstraintsAreWaitedFor)
{
    constraint(1.4, 3, 50ms);
    constraint(1.5, 2, 30ms);
    solveTo(std::make_shared<GoalUnion>(group.setup.getSpaceInformation(), goals));
}

TEST_F(LateGoals, OfSeveralConstraintsThatAreThereAtOnceAreTaken)
{
    constraint(1.4, 3, 0ms);
    constraint(1.5, 2, 0ms);
    solveTo(std::make_shared<GoalUnion>(group.setup.getSpaceInformation(), goals));
}

TEST_F(LateGoals, OfWhichOneConstraintHasNoneComeFromTheOther)
{
    constraint(1.0, 4, 0ms);  // inside the wall
    constraint(1.5, 1, 50ms);
    solveTo(std::make_shared<GoalUnion>(group.setup.getSpaceInformation(), goals));
}
}  // namespace
}  // namespace specplan::test
