// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/StopSignal.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <thread>

#include "FakeChecker.h"
#include "specplan/validity/BrokenOff.h"
#include "specplan/validity/Broker.h"
#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::validity
{
namespace
{
using test::FakeChecker;
using test::stateCheck;

constexpr std::chrono::milliseconds kOne{1};

void sleep(int milliseconds)
{
    std::this_thread::sleep_for(std::chrono::milliseconds{milliseconds});
}

void submit(Executor& executor, std::uint32_t count)
{
    for (std::uint32_t node = 0; node < count; ++node)
        executor.submit(stateCheck(node), Urgency::Speculative);
}

void finishAll(Executor& executor)
{
    std::vector<Completion> completions;
    while (executor.busy())
        executor.collect(completions, kOne);
}

TEST(StopSignal, NothingThatIsQueuedBeginsOnceTheConditionIsTrue)
{
    for (const unsigned workers : {2U, 16U, 128U})
    {
        FakeChecker checker;
        checker.during = [](CheckId, unsigned) { sleep(1); };
        ThreadPoolExecutor executor(checker, workers);
        bool stop = false;
        executor.stopSignal().watch([&stop] { return stop; });
        EXPECT_FALSE(executor.stopSignal().ask());
        submit(executor, 1000);
        stop = true;
        EXPECT_TRUE(executor.stopSignal().ask());
        const int before = checker.calls;
        sleep(60);
        EXPECT_LE(checker.calls, before + static_cast<int>(workers)) << "those that were being taken just then";
        std::vector<CheckId> dropped;
        executor.cancelQueued(dropped);
        EXPECT_GT(dropped.size(), 0U);
        finishAll(executor);
        EXPECT_EQ(checker.calls + static_cast<int>(dropped.size()), 1000);
    }
}

TEST(StopSignal, NothingBeginsForLongWhileNobodyAsksTheCondition)
{
    for (const unsigned workers : {2U, 16U})
    {
        FakeChecker checker;
        checker.during = [](CheckId, unsigned) { sleep(1); };
        ThreadPoolExecutor executor(checker, workers);
        executor.stopSignal().watch([] { return false; });
        submit(executor, 1000);
        sleep(300);  // as in a long check of the search thread's own
        const int meanwhile = checker.calls;
        EXPECT_LE(meanwhile, 100 * static_cast<int>(workers) / 4) << workers;
        for (int i = 0; i < 20; ++i)
        {
            EXPECT_FALSE(executor.stopSignal().ask());
            sleep(1);
        }
        EXPECT_GT(checker.calls, meanwhile) << "they go on as soon as it is asked";
        std::vector<CheckId> dropped;
        executor.cancelQueued(dropped);
        finishAll(executor);
    }
}

TEST(StopSignal, ReleasedWorkersTakeUpWhatIsQueued)
{
    FakeChecker checker;
    ThreadPoolExecutor executor(checker, 16);
    executor.stopSignal().watch([] { return true; });
    EXPECT_TRUE(executor.stopSignal().ask());
    submit(executor, 100);
    sleep(5);
    EXPECT_EQ(checker.calls, 0);
    executor.stopSignal().watch({});
    finishAll(executor);
    EXPECT_EQ(checker.calls, 100);
}

TEST(StopSignal, LongChecksAreLeftToThreadsOfTheirOwnSoThatTheSearchThreadCanAsk)
{
    FakeChecker checker;
    const auto searchThread = std::this_thread::get_id();
    std::atomic<int> here{0};
    std::atomic<int> milliseconds{6};
    std::array<std::atomic<bool>, 2> numbers{};
    std::atomic<int> clashes{0};
    checker.during = [&](CheckId, unsigned worker)
    {
        clashes += numbers[worker].exchange(true) ? 1 : 0;
        here += std::this_thread::get_id() == searchThread ? 1 : 0;
        if (milliseconds > 0)
            sleep(milliseconds);
        numbers[worker] = false;
    };
    ThreadPoolExecutor executor(checker, 2);
    EXPECT_TRUE(executor.worksHere());
    (void)executor.runHere(stateCheck(0));
    EXPECT_FALSE(executor.worksHere()) << "that took 6 ms";
    submit(executor, 10);
    finishAll(executor);
    EXPECT_EQ(here, 1);
    EXPECT_EQ(checker.mostAtOnce, 2);

    milliseconds = 0;
    submit(executor, 100);
    finishAll(executor);
    EXPECT_TRUE(executor.worksHere()) << "now they are short";
    submit(executor, 100);
    finishAll(executor);
    EXPECT_EQ(clashes, 0) << "two threads with the same number";
    EXPECT_LE(checker.mostAtOnce, 2);
}

/// Motions of so many states of a millisecond, between which the signal is looked at.
class StoppableMotions : public FakeChecker
{
public:
    explicit StoppableMotions(int states) : states_(states)
    {
        during = [this](CheckId check, unsigned) { run(check); };
    }

    [[nodiscard]] bool stopsInside() const noexcept override
    {
        return true;
    }

    StopSignal* stop = nullptr;
    std::atomic<int> looked{0};
    std::atomic<int> finished{0};

private:
    void run(CheckId check)
    {
        StopSignal::Look look;
        for (int i = 0; check.isMotion() && i < states_; ++i)
        {
            if (stop->isSetInside(look))
                throw BrokenOff();
            sleep(1);
            ++looked;
        }
        ++finished;
    }

    int states_;
};

std::unique_ptr<Executor> executorOfKind(Checker& checker, int kind)
{
    if (kind == 0)
        return std::make_unique<InlineExecutor>(checker);
    if (kind == 1)
        return std::make_unique<VirtualExecutor>(checker, 4, [](CheckId, bool) { return 1.0; });
    return std::make_unique<ThreadPoolExecutor>(checker, static_cast<unsigned>(kind));
}

std::vector<CheckId> motions(std::uint32_t count)
{
    std::vector<CheckId> all;
    for (std::uint32_t motion = 0; motion < count; ++motion)
        all.push_back(CheckId::ofMotion(motion));
    return all;
}

TEST(StopSignal, AMotionIsBrokenOffBetweenItsStatesAndCanBeCheckedLater)
{
    constexpr int kStates = 200;
    for (const int kind : {0, 1, 2, 8, 20})
    {
        StoppableMotions checker(kStates);
        const std::unique_ptr<Executor> executor = executorOfKind(checker, kind);
        checker.stop = &executor->stopSignal();
        Broker broker(*executor);
        broker.setWarmUp(0.0);
        broker.setInterrupt([&] { return checker.looked >= 20; });
        EXPECT_FALSE(broker.demand(motions(6))) << kind;
        broker.settle();
        EXPECT_LT(checker.looked, kStates) << kind;
        EXPECT_EQ(checker.finished, 0) << kind;
        const CheckStatistics& counts = broker.statistics();
        EXPECT_EQ(counts.checksRun, 0U) << kind;
        EXPECT_EQ(counts.demandedChecks, 0U) << kind;
        EXPECT_EQ(counts.failuresForgotten, 0U) << kind;
        EXPECT_EQ(broker.verdict(CheckId::ofMotion(0)), Verdict::Unknown) << kind;

        broker.setInterrupt({});
        EXPECT_TRUE(broker.demand(motions(6))) << kind;
        EXPECT_EQ(checker.finished, 6) << kind;
        EXPECT_EQ(counts.checksRun, 6U) << kind;
        EXPECT_EQ(counts.checksUsed, 6U) << kind;
    }
}

TEST(StopSignal, WhatTheConditionThrowsInsideOfACheckIsNotTheChecks)
{
    for (const int kind : {0, 2, 20})
    {
        StoppableMotions checker(50);
        const std::unique_ptr<Executor> executor = executorOfKind(checker, kind);
        checker.stop = &executor->stopSignal();
        Broker broker(*executor);
        broker.setInterrupt([&]() -> bool
                            { return checker.looked >= 5 ? throw std::runtime_error("condition") : false; });
        EXPECT_THROW((void)broker.demand(motions(2)), std::runtime_error) << kind;
        broker.settle();
        broker.setInterrupt({});
        EXPECT_TRUE(broker.demand(motions(2))) << kind;
        EXPECT_EQ(checker.finished, 2) << kind;
        EXPECT_EQ(broker.statistics().failuresForgotten, 0U) << kind;
    }
}

TEST(StopSignal, IsLookedAtAfterTheFirstCheckThatShowsWhatOneCosts)
{
    FakeChecker checker;
    checker.during = [](CheckId, unsigned) { sleep(6); };
    ThreadPoolExecutor executor(checker, 4);
    Broker broker(executor);
    broker.setInterrupt([&checker] { return checker.calls >= 1; });
    EXPECT_FALSE(broker.demand(std::vector{stateCheck(0), stateCheck(2), stateCheck(4)}));
    broker.settle();
    EXPECT_EQ(checker.calls, 1) << "no worker begins before the condition is asked again";
}

TEST(StopSignal, VirtualWorkersBeginNothingEither)
{
    FakeChecker checker;
    checker.during = [](CheckId, unsigned) { sleep(2); };
    VirtualExecutor executor(checker, 128, [](CheckId, bool) { return 1.0; });
    Broker broker(executor);
    broker.setInterrupt([&checker] { return checker.calls >= 3; });
    std::vector<CheckId> many;
    for (std::uint32_t node = 0; node < 100; ++node)
        many.push_back(stateCheck(node));
    EXPECT_FALSE(broker.demand(many));
    EXPECT_LE(checker.calls, 5);
    broker.settle();
    broker.setInterrupt({});
    EXPECT_TRUE(broker.demand(many));
    EXPECT_EQ(checker.calls, 100) << "each once";
}
}  // namespace
}  // namespace specplan::validity
