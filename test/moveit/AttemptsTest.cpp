// SPDX-License-Identifier: BSD-3-Clause
// Several planning attempts at the same time, as MoveIt makes them with num_planning_attempts.
#include <chrono>
#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/tools/multiplan/ParallelPlan.h>

#include "Group.h"
#include "specplan/planner/PlannerAllocator.h"

namespace specplan::test
{
namespace
{
using namespace std::chrono_literals;

constexpr int kAttempts = 4;

bool wallWithWideGap(const double* v)
{
    return std::abs(v[0] - 1.0) > 0.2 || v[1] > 1.0;
}

/// What the attempts at one problem came to.
struct Outcome
{
    bool solved = false;
    int mostChecksAtOnce = 0;
    std::set<std::uint64_t> orders;  ///< hashes of their expansions
    std::set<double> costs;
};

/// \param threads that each attempt asks for.
Outcome attempt(const PlannerAllocator& allocator, unsigned threads, std::chrono::microseconds latency)
{
    Group group({{Joint::Kind::Revolute, 2.0}, {Joint::Kind::Revolute, 2.0}}, wallWithWideGap, latency);
    group.setup.setStartAndGoalStates(group.state({-0.5, 0.1}), group.state({1.7, 0.2}));
    std::vector<std::shared_ptr<SpeculativeAStar>> planners;
    const auto allocate = [&](const ob::SpaceInformationPtr& si)
    {
        planners.push_back(allocator.allocate(si, "attempt",
                                              {{"num_threads", std::to_string(threads)},
                                               {"weight", "1"},
                                               {"resolution", "0.1"},
                                               {"speculation_policy", "runahead"}}));
        return planners.back();
    };
    group.setup.setPlannerAllocator(allocate);
    group.setup.setup();
    ompl::tools::ParallelPlan parallel(group.setup.getProblemDefinition());
    planners.clear();
    for (int i = 0; i < kAttempts; ++i)
        parallel.addPlannerAllocator(allocate);
    group.counts.most = 0;
    Outcome outcome;
    outcome.solved =
        static_cast<bool>(parallel.solve(ob::timedPlannerTerminationCondition(60.0), kAttempts, kAttempts, false));
    outcome.mostChecksAtOnce = group.counts.most;
    for (const auto& planner : planners)
    {
        outcome.orders.insert(planner->getReport().orderHash);
        outcome.costs.insert(planner->getReport().cost);
    }
    return outcome;
}

TEST(Attempts, NeverRunMoreChecksAtOnceThanTheirBudgetAndFindTheSame)
{
    std::set<std::uint64_t> orders;
    std::set<double> costs;
    for (const auto latency : {500us, 6000us})  // the search thread works in the one case, and watches in the other
        for (const unsigned budget : {1U, 4U, 6U, 12U})
        {
            if (latency > 1000us && budget < 6)
                continue;  // takes long, and is the same
            const Outcome outcome = attempt(PlannerAllocator(std::make_shared<ThreadBudget>(budget)), 8, latency);
            EXPECT_TRUE(outcome.solved);
            EXPECT_LE(outcome.mostChecksAtOnce, std::max(static_cast<int>(budget), kAttempts)) << budget;
            if (budget > static_cast<unsigned>(kAttempts))
            {
                EXPECT_GT(outcome.mostChecksAtOnce, kAttempts) << "what there is is used";
            }
            orders.insert(outcome.orders.begin(), outcome.orders.end());
            costs.insert(outcome.costs.begin(), outcome.costs.end());
        }
    EXPECT_EQ(orders.size(), 1U) << "whatever threads an attempt gets, it expands the same states";
    EXPECT_EQ(costs.size(), 1U);
}

TEST(Attempts, WithoutABudgetTakeAsManyEach)
{
    const Outcome outcome = attempt(PlannerAllocator(nullptr), 4, 500us);
    EXPECT_TRUE(outcome.solved);
    EXPECT_GT(outcome.mostChecksAtOnce, 2 * kAttempts);
}

TEST(Attempts, OneAfterTheOtherHasTheWholeBudget)
{
    const auto budget = std::make_shared<ThreadBudget>(6);
    const PlannerAllocator allocator(budget);
    for (int i = 0; i < 2; ++i)
    {
        Group group({{Joint::Kind::Revolute, 2.0}, {Joint::Kind::Revolute, 2.0}}, wallWithWideGap, 500us);
        group.setup.setStartAndGoalStates(group.state({-0.5, 0.1}), group.state({1.7, 0.2}));
        const auto planner = allocator.allocate(group.setup.getSpaceInformation(), "", {{"num_threads", "16"}});
        group.setup.setPlanner(planner);
        group.setup.setup();
        group.counts.most = 0;
        ASSERT_EQ(planner->ob::Planner::solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(planner->getReport().threads, 6U);
        EXPECT_LE(group.counts.most, 6);
        EXPECT_GT(group.counts.most, 4);
    }
}

TEST(Attempts, ABudgetMayChangeBetweenQueries)
{
    Group group({{Joint::Kind::Revolute, 2.0}, {Joint::Kind::Revolute, 2.0}}, wallWithWideGap, 200us);
    PlannerSettings settings;
    settings.numThreads = 8;
    auto& planner = group.plan({-0.5, 0.1}, {1.7, 0.2}, settings);
    group.setup.setup();
    std::set<std::uint64_t> orders;
    for (const unsigned threads : {2U, 5U, 0U, 1U, 3U})
    {
        planner.setThreadBudget(threads == 0 ? nullptr : std::make_shared<ThreadBudget>(threads));
        group.counts.most = 0;
        ASSERT_EQ(planner.ob::Planner::solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_LE(group.counts.most, static_cast<int>(threads == 0 ? 8 : threads));
        orders.insert(planner.getReport().orderHash);
    }
    EXPECT_EQ(orders.size(), 1U);
}
}  // namespace
}  // namespace specplan::test
