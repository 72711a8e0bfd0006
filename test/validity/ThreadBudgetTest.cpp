// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "specplan/validity/BudgetShare.h"

namespace specplan::validity
{
namespace
{
const auto never = [] { return false; };
const auto atOnce = [] { return true; };

TEST(ThreadBudget, HasAtLeastOneThread)
{
    EXPECT_GE(ThreadBudget().threads(), 1U);
    EXPECT_EQ(ThreadBudget(3).threads(), 3U);
}

TEST(ThreadBudget, LendsWhatThoseWhoSolveLeave)
{
    const auto budget = std::make_shared<ThreadBudget>(4);
    BudgetShare one(budget);
    const BudgetSeat seat(std::make_shared<BudgetShare>(budget));
    EXPECT_EQ(one.limit(), 3U);
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(one.borrow(never));
    EXPECT_FALSE(one.borrow(atOnce)) << "there is none left";
    one.giveBack();
    EXPECT_TRUE(one.borrow(never));
    for (int i = 0; i < 3; ++i)
        one.giveBack();
}

TEST(ThreadBudget, IsSharedEquallyByThoseWhoSolveNow)
{
    const auto budget = std::make_shared<ThreadBudget>(8);
    const auto one = std::make_shared<BudgetShare>(budget);
    const auto other = std::make_shared<BudgetShare>(budget);
    const BudgetSeat first(one);
    EXPECT_EQ(one->limit(), 7U);
    {
        const BudgetSeat second(other);
        EXPECT_EQ(one->limit(), 3U);
        EXPECT_EQ(other->limit(), 3U);
        for (int i = 0; i < 3; ++i)
            EXPECT_TRUE(one->borrow(never));
        EXPECT_FALSE(one->borrow(atOnce)) << "the rest is for the other one";
        for (int i = 0; i < 3; ++i)
            EXPECT_TRUE(other->borrow(never));
        EXPECT_FALSE(other->borrow(atOnce));
        for (int i = 0; i < 3; ++i)
            other->giveBack();
    }
    EXPECT_EQ(one->limit(), 7U);
    EXPECT_TRUE(one->borrow(never));
    for (int i = 0; i < 4; ++i)
        one->giveBack();
}

TEST(ThreadBudget, MorePlannersThanThreadsHaveOneEach)
{
    const auto budget = std::make_shared<ThreadBudget>(2);
    std::vector<std::unique_ptr<BudgetSeat>> seats;
    const auto share = std::make_shared<BudgetShare>(budget);
    seats.push_back(std::make_unique<BudgetSeat>(share));
    for (int i = 0; i < 4; ++i)
        seats.push_back(std::make_unique<BudgetSeat>(std::make_shared<BudgetShare>(budget)));
    EXPECT_EQ(share->limit(), 0U);
    EXPECT_FALSE(share->borrow(atOnce));
}

TEST(ThreadBudget, WhoeverBeginsWaitsForACheckToEndAndGoesFirst)
{
    const auto budget = std::make_shared<ThreadBudget>(2);
    BudgetShare one(budget);
    const auto other = std::make_shared<BudgetShare>(budget);
    one.enter();
    ASSERT_TRUE(one.borrow(never));
    std::atomic<bool> entered{false};
    std::thread begins(
        [&]
        {
            other->enter();
            entered = true;
        });
    while (one.limit() != 0)  // until the other one waits
        std::this_thread::yield();
    EXPECT_FALSE(entered);
    EXPECT_FALSE(one.borrow(atOnce));
    one.giveBack();
    begins.join();
    EXPECT_TRUE(entered);
    EXPECT_FALSE(one.borrow(atOnce)) << "both have one, and that is all";
    other->leave();
    EXPECT_TRUE(one.borrow(never));
    one.giveBack();
    one.leave();
}

TEST(ThreadBudget, WakesThoseWhoGiveUp)
{
    const auto budget = std::make_shared<ThreadBudget>(1);
    BudgetShare share(budget);
    share.enter();
    std::atomic<bool> gaveUp{false};
    std::thread waits([&] { EXPECT_FALSE(share.borrow([&] { return gaveUp.load(); })); });
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    gaveUp = true;
    share.wake();
    waits.join();
    share.leave();
}

TEST(ThreadBudget, IsNeverOverdrawnByManyWhoComeAndGo)
{
    constexpr unsigned kThreads = 3;
    const auto budget = std::make_shared<ThreadBudget>(kThreads);
    std::atomic<int> running{0};
    std::atomic<int> most{0};
    const auto run = [&]
    {
        const int now = ++running;
        for (int before = most; now > before && !most.compare_exchange_weak(before, now);)
        {
        }
        std::this_thread::yield();
        --running;
    };
    std::vector<std::thread> planners;
    for (int planner = 0; planner < 3; ++planner)
        planners.emplace_back(
            [&]
            {
                for (int round = 0; round < 100; ++round)
                {
                    const auto share = std::make_shared<BudgetShare>(budget);
                    const BudgetSeat seat(share);
                    std::atomic<bool> done{false};
                    std::thread helper(
                        [&]
                        {
                            while (share->borrow([&] { return done.load(); }))
                            {
                                run();
                                share->giveBack();
                            }
                        });
                    for (int i = 0; i < 20; ++i)
                        run();
                    done = true;
                    share->wake();
                    helper.join();
                }
            });
    for (std::thread& planner : planners)
        planner.join();
    EXPECT_LE(most, static_cast<int>(kThreads));
    EXPECT_GT(most, 1);
}
}  // namespace
}  // namespace specplan::validity
