// SPDX-License-Identifier: BSD-3-Clause
// What is promised of user code that is not thread-safe: docs/thread-safety.md.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/ObjectiveCosts.h"
#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Counts how often two threads are in the same object.
class Guard
{
public:
    /// \return whether somebody else is in here.
    bool use() const
    {
        const bool clash = ++inside_ > 1;
        clashes += clash ? 1 : 0;
        most = std::max(most.load(), inside_.load());
        std::this_thread::sleep_for(std::chrono::microseconds(20));
        --inside_;
        return clash;
    }

    mutable std::atomic<int> clashes{0};
    mutable std::atomic<int> most{0};

private:
    mutable std::atomic<int> inside_{0};
};

double radius(const ob::State* state)
{
    const auto* at = state->as<ob::RealVectorStateSpace::StateType>();
    return std::hypot(at->values[0], at->values[1]);
}

/// Keeps scratch space, as it were.
class StatefulChecker : public ob::StateValidityChecker
{
public:
    StatefulChecker(const ob::SpaceInformationPtr& si, std::atomic<int>& clashes)
        : StateValidityChecker(si), clashes_(clashes)
    {
    }

    bool isValid(const ob::State* state) const override
    {
        clashes_ += guard_.use() ? 1 : 0;
        return radius(state) < 0.3 || radius(state) > 0.5 ||
               state->as<ob::RealVectorStateSpace::StateType>()->values[0] < 0.0;
    }

    double clearance(const ob::State* state) const override
    {
        clashes_ += guard_.use() ? 1 : 0;
        return std::abs(radius(state) - 0.4);
    }

private:
    Guard guard_;
    std::atomic<int>& clashes_;
};

/// An objective of one's own, with scratch space.
class StatefulObjective : public ob::StateCostIntegralObjective
{
public:
    explicit StatefulObjective(const ob::SpaceInformationPtr& si) : StateCostIntegralObjective(si)
    {
    }

    ob::Cost motionCost(const ob::State* from, const ob::State* to) const override
    {
        guard.use();
        return StateCostIntegralObjective::motionCost(from, to);
    }

    Guard guard;
};

struct Scene
{
    explicit Scene(bool allocator) : setup(std::make_shared<ob::RealVectorStateSpace>(2))
    {
        setup.getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(-1.0, 1.0);
        const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
        setup.setStateValidityChecker(std::make_shared<StatefulChecker>(si, clashesShared));
        ob::ScopedState<> start(setup.getStateSpace());
        ob::ScopedState<> goal(setup.getStateSpace());
        start[0] = start[1] = 0.0;
        goal[0] = 0.8;
        goal[1] = 0.1;
        setup.setStartAndGoalStates(start, goal);
        PlannerSettings settings;
        settings.numThreads = 8;
        settings.anytime = false;
        settings.spacing = {0.1};
        planner = std::make_shared<SpeculativeAStar>(si, settings);
        if (allocator)
            planner->setStateValidityCheckerAllocator([this](const ob::SpaceInformationPtr& its, unsigned)
                                                      { return std::make_shared<StatefulChecker>(its, clashesOwn); });
        setup.setPlanner(planner);
    }

    /// \return how often two threads were in the shared checker.
    int solve()
    {
        EXPECT_EQ(setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_GT(planner->getReport().checksUsed, 50U);
        EXPECT_EQ(clashesOwn, 0);
        return clashesShared;
    }

    std::atomic<int> clashesShared{0};
    std::atomic<int> clashesOwn{0};
    og::SimpleSetup setup;
    std::shared_ptr<SpeculativeAStar> planner;
};

TEST(ThreadSafety, WhereEachWorkerHasACheckerTheSharedOneIsNotCalledByTwo)
{
    Scene scene(true);
    scene.setup.setOptimizationObjective(
        std::make_shared<ob::MaximizeMinClearanceObjective>(scene.setup.getSpaceInformation()));
    EXPECT_EQ(scene.solve(), 0);
}

TEST(ThreadSafety, AnObjectiveOfOnesOwnIsAloneWithAnAllocatorAndElseNot)
{
    for (const bool allocator : {true, false})
    {
        Scene scene(allocator);
        auto objective = std::make_shared<StatefulObjective>(scene.setup.getSpaceInformation());
        scene.setup.setOptimizationObjective(objective);
        (void)scene.solve();
        if (allocator)
            EXPECT_EQ(objective->guard.clashes, 0);
        else
            EXPECT_GT(objective->guard.clashes, 0) << "nothing is gained by many threads";
        EXPECT_LE(objective->guard.most, 8);
    }
}

TEST(ThreadSafety, ObjectivesThatAskNoCheckerAreKnown)
{
    const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2));
    const auto clearance = std::make_shared<ob::MaximizeMinClearanceObjective>(si);
    const auto length = std::make_shared<ob::PathLengthOptimizationObjective>(si);
    EXPECT_TRUE(planner::asksNoChecker(*length));
    EXPECT_TRUE(planner::asksNoChecker(ob::MechanicalWorkOptimizationObjective(si)));
    EXPECT_TRUE(planner::asksNoChecker(ob::StateCostIntegralObjective(si)));
    EXPECT_FALSE(planner::asksNoChecker(*clearance));
    EXPECT_FALSE(planner::asksNoChecker(StatefulObjective(si))) << "nobody knows what a class of one's own does";
    ob::MultiOptimizationObjective both(si);
    both.addObjective(length, 1.0);
    EXPECT_TRUE(planner::asksNoChecker(both));
    both.addObjective(clearance, 1.0);
    EXPECT_FALSE(planner::asksNoChecker(both));
}
}  // namespace
}  // namespace specplan::test
