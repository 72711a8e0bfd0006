// SPDX-License-Identifier: BSD-3-Clause
// Exact times of the simulated pool, with durations and a search clock of the test's own.
#include "specplan/validity/SimulatedPool.h"

#include <gtest/gtest.h>

#include "FakeChecker.h"

namespace specplan::validity
{
namespace
{
using test::FakeChecker;
using test::stateCheck;

constexpr std::chrono::milliseconds kMoment{1};
constexpr std::chrono::milliseconds kAtOnce{0};
constexpr unsigned kMany = PoolRules::kFewWorkers + 1;  ///< so many that the search thread is none of them

using Nodes = std::vector<std::uint32_t>;

class SimulatedPoolTest : public testing::Test
{
protected:
    /// A check of node n lasts n seconds. Handing over costs nothing and threads do not sleep unless a test says so.
    SimulatedPool::Timing timing()
    {
        SimulatedPool::Timing timing;
        timing.ofCheck = [](CheckId check, bool) { return static_cast<double>(check.node()); };
        timing.ofSearch = [this] { return work; };
        timing.handOver = 0.0;
        timing.wake = 0.0;
        return timing;
    }

    static void submit(SimulatedPool& pool, const Nodes& nodes, Urgency urgency = Urgency::Speculative)
    {
        for (const std::uint32_t node : nodes)
            pool.submit(stateCheck(node), urgency);
    }

    static Nodes collected(SimulatedPool& pool, std::chrono::milliseconds patience)
    {
        std::vector<Completion> completions;
        pool.collect(completions, patience);
        Nodes nodes;
        for (const Completion& completion : completions)
            nodes.push_back(completion.check.node());
        return nodes;
    }

    FakeChecker checker;
    double work = 100.0;  ///< seconds that the search has worked; begins anywhere
};

TEST_F(SimulatedPoolTest, OneWorkerIsSequentialAndTheSearchsWorkCounts)
{
    SimulatedPool pool(checker, 1, timing());
    EXPECT_TRUE(pool.runsInline());
    EXPECT_TRUE(pool.canRunHere());
    EXPECT_EQ(pool.room(), 0U);
    EXPECT_EQ(pool.now(), 0.0);
    const Completion first = pool.runHere(stateCheck(4));
    EXPECT_TRUE(first.valid);
    EXPECT_EQ(first.seconds, 4.0);
    EXPECT_EQ(pool.now(), 4.0);
    work += 0.5;
    EXPECT_EQ(pool.now(), 4.5);
    EXPECT_FALSE(pool.runHere(stateCheck(3)).valid);
    EXPECT_EQ(pool.now(), 7.5);
}

TEST_F(SimulatedPoolTest, WhatTheSearchDoesInsideOfTheExecutorIsNotItsWork)
{
    SimulatedPool pool(checker, 1, timing());
    checker.during = [this](CheckId, unsigned) { work += 50.0; };  // the real check, or looking it up
    EXPECT_EQ(pool.runHere(stateCheck(4)).seconds, 4.0);
    EXPECT_EQ(pool.now(), 4.0);
}

TEST_F(SimulatedPoolTest, WorkersGoOnWhileTheSearchWorks)
{
    SimulatedPool pool(checker, kMany, timing());
    Nodes nodes(kMany, 10);
    nodes[0] = 2;
    submit(pool, nodes);
    submit(pool, {3});  // queued
    EXPECT_EQ(pool.freeWorkers(), 0U);
    EXPECT_EQ(collected(pool, kAtOnce), Nodes{}) << "no time has passed";
    work += 4.0;
    EXPECT_TRUE(pool.runsDry()) << "the one that is done has taken the queued one";
    EXPECT_EQ(collected(pool, kAtOnce), Nodes{2});
    EXPECT_FALSE(pool.runsDry()) << "all workers are busy";
    work += 1.0;
    EXPECT_TRUE(pool.runsDry());
    EXPECT_EQ(collected(pool, kAtOnce), Nodes{3}) << "began at 2, ended at 5, while the search worked";
    EXPECT_EQ(pool.now(), 5.0);
    EXPECT_EQ(collected(pool, kMoment), Nodes(kMany - 1, 10));
    EXPECT_EQ(pool.now(), 10.0);
    EXPECT_FALSE(pool.busy());
    EXPECT_EQ(collected(pool, kMoment), Nodes{}) << "nothing to wait for";
    EXPECT_EQ(pool.now(), 10.0);
}

TEST_F(SimulatedPoolTest, OfFewWorkersTheSearchThreadIsOne)
{
    SimulatedPool pool(checker, 2, timing());
    submit(pool, {7, 4, 2});
    // One thread has 7; instead of waiting the search takes 4, and then 2.
    EXPECT_EQ(collected(pool, kMoment), Nodes{4});
    EXPECT_EQ(pool.now(), 4.0);
    EXPECT_EQ(collected(pool, kMoment), Nodes{2});
    EXPECT_EQ(pool.now(), 6.0);
    EXPECT_EQ(collected(pool, kMoment), Nodes{7});
    EXPECT_EQ(pool.now(), 7.0);
    EXPECT_EQ(checker.calls, 3);
}

TEST_F(SimulatedPoolTest, HandingOverTakesTheSearchAMoment)
{
    SimulatedPool::Timing costly = timing();
    costly.handOver = 0.25;
    SimulatedPool pool(checker, kMany, costly);
    submit(pool, {4, 4});
    EXPECT_EQ(pool.now(), 0.5);
    EXPECT_EQ(collected(pool, kMoment), Nodes{4});
    EXPECT_EQ(pool.now(), 4.25);
    EXPECT_EQ(collected(pool, kMoment), Nodes{4});
    EXPECT_EQ(pool.now(), 4.5);
}

TEST_F(SimulatedPoolTest, ThreadsThatHaveHadNothingToDoHaveToWakeUp)
{
    SimulatedPool::Timing sleepy = timing();
    sleepy.wake = 0.5;
    sleepy.afterCheck = 0.125;
    SimulatedPool pool(checker, 2, sleepy);
    submit(pool, {4});
    EXPECT_EQ(collected(pool, kMoment), Nodes{4});
    EXPECT_EQ(pool.now(), 5.0) << "the worker and then the search had to wake up";
    submit(pool, {2, 4});
    EXPECT_EQ(collected(pool, kMoment), (Nodes{4, 2})) << "2 began at 5.5 and came back during 4";
    EXPECT_EQ(pool.now(), 9.125) << "the search needs a moment after a check of its own";
}

TEST_F(SimulatedPoolTest, DemandedChecksOvertakeAndQueuedOnesCanBeTakenBack)
{
    SimulatedPool pool(checker, kMany, timing());
    submit(pool, Nodes(kMany, 20));
    submit(pool, {2, 3});
    submit(pool, {4}, Urgency::Demanded);
    pool.promote(stateCheck(3));
    std::vector<CheckId> dropped;
    pool.cancelUnwanted([](CheckId check) { return check.node() != 2; }, dropped);
    EXPECT_EQ(dropped, std::vector<CheckId>{stateCheck(2)});
    EXPECT_EQ(collected(pool, kMoment), Nodes(kMany, 20));
    EXPECT_EQ(collected(pool, kMoment), Nodes{3});
    EXPECT_EQ(collected(pool, kMoment), Nodes{4});
    EXPECT_EQ(pool.now(), 24.0);

    submit(pool, Nodes(kMany, 20));
    submit(pool, {2}, Urgency::Demanded);
    dropped.clear();
    pool.cancelQueued(dropped);
    EXPECT_EQ(dropped, std::vector<CheckId>{stateCheck(2)});
    EXPECT_EQ(collected(pool, kMoment), Nodes(kMany, 20));
    EXPECT_FALSE(pool.busy());
}

TEST(Supply, LastsUntilTheSearchThreadIsBack)
{
    Supply equal;
    Supply mixed;
    for (std::uint32_t i = 0; i < 1000; ++i)
    {
        equal.learn(stateCheck(i), 1e-3);
        mixed.learn(stateCheck(i), 10e-6);
        if (i % 10 == 0)
            mixed.learn(CheckId::ofMotion(i), 1e-3);
    }
    EXPECT_EQ(equal.room(4, true, 0, {0, 0}), 8U);
    EXPECT_EQ(equal.room(4, true, 4, {0, 0}), 4U);
    EXPECT_EQ(equal.room(4, true, 6, {2, 0}), 2U);
    EXPECT_EQ(equal.room(4, true, 8, {4, 0}), 0U);
    EXPECT_GT(mixed.room(4, true, 24, {20, 0}), 20U) << "cheap states are gone before a motion is over";
    EXPECT_EQ(mixed.room(4, true, 8, {0, 4}), 0U);
}

TEST(Supply, LastsAsLongAsTheSearchUsuallyThinks)
{
    Supply supply;
    for (std::uint32_t i = 0; i < 1000; ++i)
        supply.learn(stateCheck(i), 20e-6);
    EXPECT_EQ(supply.room(2, true, 0, {0, 0}), 6U);
    for (int i = 0; i < 1000; ++i)
        supply.learnThought(i % 10 == 0 ? 200e-6 : 0.0);
    EXPECT_NEAR(supply.room(2, true, 0, {0, 0}), 10U, 3U) << "long thoughts count for more, but not for all";
    for (int i = 0; i < 1000; ++i)
        supply.learnThought(205e-6);
    EXPECT_EQ(supply.room(2, true, 0, {0, 0}), 22U);
    EXPECT_EQ(supply.room(2, true, 20, {18, 0}), 2U);
    for (int i = 0; i < 1000; ++i)
        supply.learnThought(1.0);
    EXPECT_EQ(supply.room(2, true, 0, {0, 0}), 48U);
    EXPECT_EQ(supply.room(16, false, 0, {0, 0}), 48U) << "with many workers something comes back all the time";
}

TEST(Supply, LetsNoWorkerGoWithout)
{
    Supply supply;
    EXPECT_EQ(supply.room(4, true, 1, {1, 0}), 3U) << "of durations nothing is known";
    supply.learn(stateCheck(1), 5e-3);
    EXPECT_EQ(supply.room(16, false, 0, {0, 0}), 16U);
    EXPECT_EQ(supply.room(16, false, 16, {0, 0}), 0U) << "the search thread is always there";
    for (std::uint32_t i = 0; i < 1000; ++i)
        supply.learn(stateCheck(i), 5e-3);
    supply.learn(CheckId::ofMotion(1), 50e-3);
    EXPECT_GT(supply.room(4, true, 3, {0, 3}), 4U) << "the search may be away for a motion, and the fourth has none";
    EXPECT_EQ(supply.room(4, false, 3, {0, 3}), 1U) << "more than enough, but not for the fourth";
}
}  // namespace
}  // namespace specplan::validity
