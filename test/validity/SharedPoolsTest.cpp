// SPDX-License-Identifier: BSD-3-Clause
// Pools that share a budget of threads.
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "FakeChecker.h"
#include "specplan/validity/ThreadPoolExecutor.h"

namespace specplan::validity
{
namespace
{
using test::FakeChecker;
using test::stateCheck;
using namespace std::chrono_literals;

/// Checks of all pools that run now, and the most there were.
struct Running
{
    std::atomic<int> now{0};
    std::atomic<int> most{0};

    void run(std::chrono::microseconds duration)
    {
        const int count = ++now;
        for (int before = most; count > before && !most.compare_exchange_weak(before, count);)
        {
        }
        std::this_thread::sleep_for(duration);
        --now;
    }
};

/// Runs so many checks in a pool, as a search does that sometimes runs one itself.
void runChecks(const std::shared_ptr<ThreadBudget>& budget, unsigned workers, std::uint32_t checks, Running& running,
               std::chrono::microseconds duration)
{
    FakeChecker checker;
    checker.during = [&](CheckId, unsigned worker)
    {
        EXPECT_LT(worker, workers);
        running.run(duration);
    };
    const auto share = std::make_shared<BudgetShare>(budget);
    ThreadPoolExecutor pool(checker, workers, share);
    std::vector<Completion> done;
    for (int search = 0; search < 3; ++search)
    {
        const BudgetSeat seat(share);
        for (std::uint32_t node = 0; node < checks; ++node)
        {
            if (pool.canRunHere() && node % 7 == 0)
                done.push_back(pool.runHere(stateCheck(node)));
            else
                pool.submit(stateCheck(node), node % 3 == 0 ? Urgency::Demanded : Urgency::Speculative);
            if (node % 5 == 0)
                pool.collect(done, 0ms);
        }
        while (pool.busy())
            pool.collect(done, 5ms);
    }
    EXPECT_EQ(done.size(), 3U * checks);
}

void runPools(unsigned threads, unsigned pools, unsigned workers, std::chrono::microseconds duration)
{
    const auto budget = std::make_shared<ThreadBudget>(threads);
    Running running;
    std::vector<std::thread> searches;
    for (unsigned i = 0; i < pools; ++i)
        searches.emplace_back([&] { runChecks(budget, workers, 60, running, duration); });
    for (std::thread& search : searches)
        search.join();
    EXPECT_LE(running.most, static_cast<int>(std::max(threads, pools)));
}

TEST(SharedPools, NeverRunMoreChecksThanTheBudgetHasThreads)
{
    for (const auto duration : {50us, 5000us})  // short ones, and such as the search thread leaves to others
        for (const unsigned threads : {1U, 2U, 3U, 6U})
            runPools(threads, 3, 4, duration);
}

TEST(SharedPools, OfManyWorkersShareFewThreads)
{
    runPools(4, 2, 16, 100us);
    runPools(12, 2, 16, 100us);
}

TEST(SharedPools, APoolThatIsAloneHasAllThreads)
{
    const auto budget = std::make_shared<ThreadBudget>(4);
    Running running;
    runChecks(budget, 8, 60, running, 500us);
    EXPECT_LE(running.most, 4);
    EXPECT_GE(running.most, 3);
}

TEST(SharedPools, EndWhileTheirThreadsWaitForOthers)
{
    const auto budget = std::make_shared<ThreadBudget>(2);
    BudgetShare other(budget);
    other.enter();
    FakeChecker checker;
    const auto share = std::make_shared<BudgetShare>(budget);
    const BudgetSeat seat(share);
    {
        ThreadPoolExecutor pool(checker, 4, share);
        for (std::uint32_t node = 0; node < 50; ++node)
            pool.submit(stateCheck(node), Urgency::Speculative);
        std::vector<CheckId> dropped;
        pool.cancelQueued(dropped);
        std::vector<Completion> done;
        while (pool.busy())
            pool.collect(done, 5ms);
        EXPECT_EQ(done.size() + dropped.size(), 50U);
    }
    other.leave();
}
}  // namespace
}  // namespace specplan::validity
