// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/ThreadPoolExecutor.h"

#include <gtest/gtest.h>

#include <latch>
#include <map>
#include <random>
#include <semaphore>
#include <set>
#include <thread>

#include "FakeChecker.h"

namespace specplan::validity
{
namespace
{
using test::FakeChecker;
using test::stateCheck;

constexpr std::chrono::milliseconds kWait{20};

std::vector<Completion> collectAll(Executor& executor)
{
    std::vector<Completion> all;
    while (executor.busy())
        executor.collect(all, kWait);
    return all;
}

TEST(ThreadPoolExecutor, StartsNoThreadBeforeItIsUsed)
{
    FakeChecker checker;
    const ThreadPoolExecutor executor(checker, 4096);  // would take seconds, and gigabytes of stack
    EXPECT_EQ(executor.workers(), 4096U);
    EXPECT_EQ(executor.freeWorkers(), 4096U);
    EXPECT_FALSE(executor.busy());
}

TEST(ThreadPoolExecutor, ThreadsStartedAheadDoTheWork)
{
    FakeChecker checker;
    ThreadPoolExecutor executor(checker, 3);
    executor.startThreads();
    executor.startThreads();  // of no effect
    for (std::uint32_t node = 0; node < 100; ++node)
        executor.submit(stateCheck(node), Urgency::Speculative);
    EXPECT_EQ(collectAll(executor).size(), 100U);
    ThreadPoolExecutor unused(checker, 3);
    unused.startThreads();  // ends all the same
}

TEST(ThreadPoolExecutor, RunsAsManyChecksAtOnceAsItHasWorkers)
{
    constexpr unsigned kWorkers = 8;
    FakeChecker checker;
    std::latch together(kWorkers);  // passes only if all eight run at the same time
    std::mutex mutex;
    std::set<unsigned> workers;
    checker.during = [&](CheckId, unsigned worker)
    {
        {
            const std::lock_guard lock(mutex);
            workers.insert(worker);
        }
        together.arrive_and_wait();
    };
    ThreadPoolExecutor executor(checker, kWorkers);
    for (std::uint32_t node = 0; node < kWorkers; ++node)
        executor.submit(stateCheck(node), Urgency::Speculative);
    EXPECT_EQ(collectAll(executor).size(), kWorkers);
    EXPECT_EQ(workers.size(), kWorkers) << "each with a number of its own";
    EXPECT_EQ(*workers.rbegin(), kWorkers - 1);
}

TEST(ThreadPoolExecutor, EveryCheckComesBackOnceWithItsVerdict)
{
    FakeChecker checker;
    ThreadPoolExecutor executor(checker, 4);
    constexpr std::uint32_t kChecks = 20000;
    std::mt19937_64 random(3);
    std::map<std::uint32_t, int> back;
    std::vector<Completion> completions;
    const auto take = [&](std::chrono::milliseconds patience)
    {
        completions.clear();
        executor.collect(completions, patience);
        for (const Completion& completion : completions)
        {
            ++back[completion.check.node()];
            ASSERT_EQ(completion.valid, completion.check.node() % 2 == 0);
            ASSERT_GE(completion.seconds, 0.0);
        }
    };
    for (std::uint32_t node = 0; node < kChecks; ++node)
    {
        executor.submit(stateCheck(node), random() % 2 == 0 ? Urgency::Demanded : Urgency::Speculative);
        if (random() % 3 == 0)
            executor.promote(stateCheck(static_cast<std::uint32_t>(random() % (node + 1))));
        if (random() % 16 == 0)
            take(std::chrono::milliseconds{0});
        if (random() % 512 == 0)
            take(kWait);
    }
    while (executor.busy())
        take(kWait);
    ASSERT_EQ(back.size(), kChecks);
    for (const auto& [node, times] : back)
        ASSERT_EQ(times, 1) << node;
    EXPECT_LE(checker.mostAtOnce, 4);
}

/// Holds the only worker in check 0 until released.
struct HeldWorker
{
    HeldWorker() : executor(checker, 1)
    {
        checker.during = [this](CheckId check, unsigned)
        {
            const std::lock_guard lock(mutex);
            order.push_back(check.node());
            if (check.node() == 0)
            {
                started.release();
                release.acquire();
            }
        };
        executor.submit(stateCheck(0), Urgency::Speculative);
        started.acquire();
    }

    FakeChecker checker;
    std::binary_semaphore started{0};
    std::binary_semaphore release{0};
    std::mutex mutex;
    std::vector<std::uint32_t> order;
    ThreadPoolExecutor executor;
};

TEST(ThreadPoolExecutor, DemandedChecksOvertakeQueuedOnes)
{
    HeldWorker held;
    held.executor.submit(stateCheck(1), Urgency::Speculative);
    held.executor.submit(stateCheck(2), Urgency::Speculative);
    held.executor.submit(stateCheck(3), Urgency::Demanded);
    held.executor.promote(stateCheck(2));
    held.release.release();
    EXPECT_EQ(collectAll(held.executor).size(), 4U);
    EXPECT_EQ(held.order, (std::vector<std::uint32_t>{0, 3, 2, 1}));
}

TEST(ThreadPoolExecutor, QueuedChecksCanBeTakenBackAndNeverRun)
{
    HeldWorker held;
    held.executor.submit(stateCheck(1), Urgency::Speculative);
    held.executor.submit(stateCheck(2), Urgency::Demanded);
    std::vector<CheckId> dropped;
    held.executor.cancelQueued(dropped);
    EXPECT_EQ((std::set<CheckId>(dropped.begin(), dropped.end())), (std::set<CheckId>{stateCheck(1), stateCheck(2)}));
    held.release.release();
    EXPECT_EQ(collectAll(held.executor).size(), 1U);
    EXPECT_EQ(held.checker.calls, 1);
}

TEST(ThreadPoolExecutor, CollectGivesUpAfterItsPatience)
{
    HeldWorker held;
    std::vector<Completion> completions;
    held.executor.collect(completions, std::chrono::milliseconds{5});
    EXPECT_TRUE(completions.empty());
    held.executor.collect(completions, std::chrono::milliseconds{0});
    EXPECT_TRUE(completions.empty());
    held.release.release();
    EXPECT_EQ(collectAll(held.executor).size(), 1U);
}

TEST(ThreadPoolExecutor, ExceptionsComeBackAsCompletions)
{
    FakeChecker checker;
    checker.during = [](CheckId check, unsigned)
    {
        if (check.node() == 1)
            throw std::runtime_error("one");
        if (check.node() == 2)
            throw 2;
    };
    ThreadPoolExecutor executor(checker, 2);
    for (const std::uint32_t node : {0U, 1U, 2U, 4U})
        executor.submit(stateCheck(node), Urgency::Speculative);
    const std::vector<Completion> all = collectAll(executor);
    ASSERT_EQ(all.size(), 4U);
    for (const Completion& completion : all)
        EXPECT_EQ(static_cast<bool>(completion.error), completion.check.node() == 1 || completion.check.node() == 2);
}

TEST(ThreadPoolExecutor, EndsWhileChecksAreQueuedAndRunning)
{
    for (int round = 0; round < 50; ++round)
    {
        FakeChecker checker;
        checker.during = [](CheckId, unsigned) { std::this_thread::yield(); };
        ThreadPoolExecutor executor(checker, 3);
        for (std::uint32_t node = 0; node < 20; ++node)
            executor.submit(stateCheck(node), Urgency::Speculative);
    }
}
}  // namespace
}  // namespace specplan::validity
