// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/Broker.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <utility>

#include "FakeChecker.h"
#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::validity
{
namespace
{
using test::FakeChecker;
using test::stateCheck;

/// Proposes what the test has put on its list, in order.
class ListSource : public CheckSource
{
public:
    void propose(std::size_t count, std::vector<CheckId>& out) override
    {
        asked.push_back(count);
        if (std::exchange(throwsInPropose, false))
            throw std::runtime_error("propose");
        for (; count > 0 && !list.empty(); --count)
        {
            out.push_back(list.front());
            list.erase(list.begin());
        }
    }

    [[nodiscard]] bool keepsAsking() const noexcept override
    {
        return asksAgain;
    }

    void learned(CheckId check, bool valid) override
    {
        if (std::exchange(throwsInLearned, false))
            throw std::runtime_error("learned");
        heard.emplace_back(check, valid);
    }

    std::vector<CheckId> list;
    std::vector<std::size_t> asked;
    std::vector<std::pair<CheckId, bool>> heard;
    bool asksAgain = false;
    bool throwsInPropose = false;
    bool throwsInLearned = false;
};

std::vector<CheckId> checks(std::initializer_list<std::uint32_t> nodes)
{
    std::vector<CheckId> out;
    for (const std::uint32_t node : nodes)
        out.push_back(stateCheck(node));
    return out;
}

/// A broker over a virtual clock; every check lasts a second unless the test says otherwise.
struct Virtual
{
    explicit Virtual(unsigned workers)
        : executor(checker, workers, [this](CheckId check, bool) { return cost ? cost(check.node()) : 1.0; }),
          broker(executor)
    {
        broker.setSource(&source);
    }

    FakeChecker checker;
    std::function<double(std::uint32_t)> cost;
    VirtualExecutor executor;
    ListSource source;
    Broker broker;
};

void expectBooksBalance(const CheckStatistics& counts)
{
    EXPECT_EQ(counts.speculativeChecks,
              counts.speculativeUsed + counts.speculativeWasted() + counts.speculativeDropped);
    EXPECT_EQ(counts.checksUsed, counts.usedReady + counts.usedAfterWait + counts.usedInline);
    EXPECT_EQ(counts.checksRun, counts.demandedChecks + counts.speculativeChecks - counts.speculativeDropped);
}

TEST(Broker, DemandRunsWhatIsMissingAtTheSameTimeAndEachOnce)
{
    Virtual v(4);
    EXPECT_TRUE(v.broker.demand(checks({0, 1, 2})));
    EXPECT_EQ(v.broker.now(), 1.0);
    EXPECT_EQ(v.broker.verdict(stateCheck(0)), Verdict::Valid);
    EXPECT_EQ(v.broker.verdict(stateCheck(1)), Verdict::Invalid);
    EXPECT_TRUE(v.broker.demand(checks({2, 1, 3, 3})));
    EXPECT_EQ(v.broker.now(), 2.0);
    EXPECT_EQ(v.checker.calls, 4);
    EXPECT_EQ(v.broker.statistics().checksUsed, 4U);
    EXPECT_EQ(v.broker.statistics().demandedChecks, 4U);
    expectBooksBalance(v.broker.statistics());
}

TEST(Broker, AsksTheSourceForAsManyChecksAsWorkersAreFreeAndOnlyWhileItWaits)
{
    Virtual v(4);
    v.source.list = checks({10, 12, 14, 16, 18});
    EXPECT_TRUE(v.broker.demand(checks({0})));
    EXPECT_EQ(v.source.asked, std::vector<std::size_t>{3});
    EXPECT_EQ(v.broker.statistics().speculativeChecks, 3U);
    EXPECT_TRUE(v.broker.demand(checks({0})));
    EXPECT_EQ(v.source.asked.size(), 1U) << "nothing is missing, nobody waits";
    EXPECT_TRUE(v.broker.demand(checks({10, 12})));
    EXPECT_EQ(v.broker.now(), 1.0) << "both were checked ahead";
    v.broker.settle();
    const CheckStatistics& counts = v.broker.statistics();
    EXPECT_EQ(counts.speculativeUsed, 2U);
    EXPECT_EQ(counts.speculativeReady, 2U);
    EXPECT_EQ(counts.speculativeWasted(), 1U);
    EXPECT_NEAR(counts.accuracy(), 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(counts.coverage(), 2.0 / 3.0, 1e-12);
    expectBooksBalance(counts);
}

TEST(Broker, NeverWaitsForASpeculativeCheckUnlessToldTo)
{
    for (const bool barrier : {false, true})
    {
        Virtual v(2);
        v.cost = [](std::uint32_t node) { return node == 10 ? 100.0 : 1.0; };
        v.source.list = checks({10});
        v.broker.setBarrier(barrier);
        EXPECT_TRUE(v.broker.demand(checks({0})));
        EXPECT_EQ(v.broker.now(), barrier ? 100.0 : 1.0);
    }
}

TEST(Broker, KeepsAskingAsWorkersFallFreeIfTheSourceLikes)
{
    Virtual v(2);
    v.cost = [](std::uint32_t node) { return node == 0 ? 3.5 : 1.0; };
    v.source.list = checks({10, 12, 14, 16, 18, 20});
    v.source.asksAgain = true;
    EXPECT_TRUE(v.broker.demand(checks({0})));
    EXPECT_EQ(v.broker.now(), 3.5);
    EXPECT_EQ(v.broker.statistics().speculativeChecks, 5U)
        << "one after the other beside the long one, and one for after it";
}

TEST(Broker, ADemandedCheckThatRunsAlreadyIsWaitedForNotRunTwice)
{
    Virtual v(2);
    v.cost = [](std::uint32_t node) { return node == 10 ? 5.0 : 1.0; };
    v.source.list = checks({10});
    EXPECT_TRUE(v.broker.demand(checks({0})));
    EXPECT_EQ(v.broker.verdict(stateCheck(10)), Verdict::InFlight);
    EXPECT_TRUE(v.broker.demand(checks({10})));
    EXPECT_EQ(v.broker.now(), 5.0);
    EXPECT_EQ(v.checker.calls, 2);
    EXPECT_EQ(v.broker.statistics().speculativeUsed, 1U);
    EXPECT_EQ(v.broker.statistics().speculativeReady, 0U);
    EXPECT_EQ(v.broker.statistics().usedAfterWait, 2U);
}

TEST(Broker, TellsTheSourceEveryVerdict)
{
    Virtual v(2);
    v.source.list = checks({11});
    EXPECT_TRUE(v.broker.demand(checks({0})));
    v.broker.settle();
    const std::vector<std::pair<CheckId, bool>> expected{{stateCheck(0), true}, {stateCheck(11), false}};
    EXPECT_EQ(v.source.heard, expected);
}

TEST(Broker, ForgetsExceptionsOfChecksThatNobodyNeeds)
{
    Virtual v(2);
    v.checker.during = [](CheckId check, unsigned)
    {
        if (check.node() == 10)
            throw std::runtime_error("ten");
    };
    v.source.list = checks({10});
    EXPECT_TRUE(v.broker.demand(checks({0})));
    v.broker.settle();
    EXPECT_EQ(v.broker.statistics().failuresForgotten, 1U);
    EXPECT_EQ(v.broker.verdict(stateCheck(10)), Verdict::Unknown);
}

TEST(Broker, ThrowsTheFirstExceptionInTheOrderOfDemand)
{
    for (const bool isInline : {false, true})
    {
        FakeChecker checker;
        checker.during = [](CheckId check, unsigned)
        {
            if (check.node() >= 10)
                throw std::runtime_error(std::to_string(check.node()));
        };
        VirtualExecutor simulated(checker, 8, [](CheckId check, bool) { return 100.0 - check.node(); });
        InlineExecutor direct(checker);
        Broker broker(isInline ? static_cast<Executor&>(direct) : simulated);
        try
        {
            (void)broker.demand(checks({0, 12, 2, 14}));
            FAIL() << "no exception";
        }
        catch (const std::runtime_error& error)
        {
            EXPECT_STREQ(error.what(), "12");
        }
        broker.settle();
        checker.during = {};
        EXPECT_TRUE(broker.demand(checks({0, 12, 2, 14}))) << "asking again tries again";
        EXPECT_EQ(broker.verdict(stateCheck(12)), Verdict::Valid);
    }
}

TEST(Broker, AnInterruptEndsALongWaitAndNothingIsLost)
{
    FakeChecker checker;
    std::atomic<bool> hold{true};
    checker.during = [&hold, here = std::this_thread::get_id()](CheckId check, unsigned)
    {
        do
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        while (hold && check.node() > 0 && std::this_thread::get_id() != here);  // or nobody would let go
    };
    ThreadPoolExecutor executor(checker, 16);  // so many that the search thread is none of them
    Broker broker(executor);
    broker.setWarmUp(0.0);
    EXPECT_TRUE(broker.demand(checks({0}))) << "shows that checks are dear";
    broker.setInterrupt([] { return true; });
    EXPECT_FALSE(broker.demand(checks({2, 4})));
    hold = false;
    broker.setInterrupt({});
    EXPECT_TRUE(broker.demand(checks({2, 4})));
    EXPECT_EQ(checker.calls, 3);
    EXPECT_EQ(broker.statistics().checksUsed, 3U);
}

TEST(Broker, AnInterruptedDemandThatIsTakenBackLeavesTheBooksBalanced)
{
    FakeChecker checker;
    std::atomic<bool> hold{true};
    checker.during = [&hold, here = std::this_thread::get_id()](CheckId check, unsigned)
    {
        do
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        while (hold && check.node() > 0 && std::this_thread::get_id() != here);  // or nobody would let go
    };
    ThreadPoolExecutor executor(checker, 10);
    Broker broker(executor);
    broker.setWarmUp(0.0);
    EXPECT_TRUE(broker.demand(checks({0})));
    std::vector<CheckId> many;
    for (std::uint32_t node = 1; node <= 30; ++node)
        many.push_back(stateCheck(node));
    broker.setInterrupt(
        [&hold]
        {
            hold = false;
            return true;
        });
    EXPECT_FALSE(broker.demand(many));
    broker.settle();
    expectBooksBalance(broker.statistics());
    broker.setInterrupt({});
    EXPECT_TRUE(broker.demand(many));
    EXPECT_EQ(checker.calls, 31) << "each once, whether it had started or not";
    EXPECT_EQ(broker.statistics().checksUsed, 31U);
    expectBooksBalance(broker.statistics());
}

/// A check that lasts as long as the test says.
struct Timed
{
    explicit Timed(unsigned workers) : executor(checker, workers), broker(executor)
    {
        checker.during = [this](CheckId, unsigned)
        {
            if (std::this_thread::get_id() != here)
                ++elsewhere;
            if (duration.count() > 0)
                std::this_thread::sleep_for(duration);
        };
        source.asksAgain = true;
        broker.setSource(&source);
    }

    /// Demands `count` checks that were never asked for, one at a time.
    void demandMore(std::uint32_t count)
    {
        for (; count > 0; --count)
            EXPECT_TRUE(broker.demand(checks({next++})));
    }

    FakeChecker checker;
    std::chrono::microseconds duration{0};
    std::atomic<int> elsewhere{0};
    std::thread::id here = std::this_thread::get_id();
    std::uint32_t next = 0;
    ListSource source;
    ThreadPoolExecutor executor;
    Broker broker;
};

TEST(Broker, CheapChecksRunInTheSearchThreadAndWakeNobody)
{
    // A machine that stalls makes cheap checks long: one undisturbed attempt of several will do.
    const auto isLeftAlone = [](unsigned workers)
    {
        Timed t(workers);
        t.demandMore(50);  // the very first ones may take their time
        const int before = t.elsewhere;
        const std::size_t askedBefore = t.source.asked.size();
        t.demandMore(200);
        expectBooksBalance(t.broker.statistics());
        return t.elsewhere == before && t.source.asked.size() == askedBefore;
    };
    for (const unsigned workers : {2U, 8U, 32U})
    {
        int attempts = 1;
        while (!isLeftAlone(workers))
            ASSERT_LT(++attempts, 6);
    }
}

TEST(Broker, DearChecksGoToTheWorkersFromTheSecondOn)
{
    Timed t(16);
    t.duration = std::chrono::milliseconds{2};
    t.source.list = checks({100, 102, 104});
    t.demandMore(3);
    EXPECT_EQ(t.broker.statistics().usedInline, 1U);
    EXPECT_FALSE(t.source.asked.empty());
}

TEST(Broker, ASourceThatThrowsLosesNothing)
{
    for (const bool inPropose : {true, false})
    {
        Virtual v(8);
        (inPropose ? v.source.throwsInPropose : v.source.throwsInLearned) = true;
        EXPECT_THROW((void)v.broker.demand(checks({0, 2, 4})), std::runtime_error);
        v.broker.settle();
        EXPECT_TRUE(v.broker.demand(checks({0, 2, 4})));
        EXPECT_EQ(v.checker.calls, 3);
        expectBooksBalance(v.broker.statistics());

        v.source.throwsInLearned = true;
        EXPECT_TRUE(v.broker.prefetch(stateCheck(6)));
        EXPECT_NO_THROW(v.broker.settle());
        EXPECT_EQ(v.broker.verdict(stateCheck(6)), Verdict::Valid);
    }
}

TEST(Broker, ABarrierEndsAlsoWithASourceThatNeverRunsOut)
{
    Virtual v(4);
    v.source.asksAgain = true;
    v.broker.setBarrier(true);
    for (std::uint32_t node = 100; node < 1000; ++node)
        v.source.list.push_back(stateCheck(node));
    EXPECT_TRUE(v.broker.demand(checks({0})));
    EXPECT_EQ(v.checker.calls, 4);
}

TEST(Broker, AFailureThatIsAskedForTwiceCountsOnce)
{
    Virtual v(2);
    v.checker.during = [](CheckId, unsigned) { throw std::runtime_error("no"); };
    EXPECT_THROW((void)v.broker.demand(checks({1})), std::runtime_error);
    EXPECT_THROW((void)v.broker.demand(checks({1})), std::runtime_error);
    EXPECT_EQ(v.broker.statistics().failuresForgotten, 0U);
}

TEST(Broker, KnowsWhatItIsTold)
{
    Virtual v(2);
    v.broker.setVerdict(stateCheck(1), true);
    EXPECT_TRUE(v.broker.demand(checks({1})));
    EXPECT_EQ(v.broker.verdict(stateCheck(1)), Verdict::Valid);
    EXPECT_EQ(v.checker.calls, 0);
}

TEST(Broker, PrefetchRefusesWhatIsKnownRunningOrPointless)
{
    Virtual v(2);
    EXPECT_TRUE(v.broker.prefetch(stateCheck(4)));
    EXPECT_FALSE(v.broker.prefetch(stateCheck(4))) << "runs";
    v.broker.settle();
    EXPECT_FALSE(v.broker.prefetch(stateCheck(4))) << "known";
    FakeChecker checker;
    InlineExecutor direct(checker);
    Broker sequential(direct);
    EXPECT_FALSE(sequential.prefetch(stateCheck(4))) << "nobody would run it beside the search";
}

TEST(Broker, SettleDropsWhatHasNotStartedAndWaitsForTheRest)
{
    Virtual v(1);
    EXPECT_TRUE(v.broker.prefetch(stateCheck(2)));
    EXPECT_TRUE(v.broker.prefetch(stateCheck(4)));
    EXPECT_TRUE(v.broker.prefetch(stateCheck(6)));
    v.broker.settle();
    EXPECT_EQ(v.checker.calls, 1);
    EXPECT_EQ(v.broker.statistics().speculativeDropped, 2U);
    EXPECT_EQ(v.broker.verdict(stateCheck(4)), Verdict::Unknown);
    EXPECT_TRUE(v.broker.prefetch(stateCheck(4))) << "may be handed out again";
    v.broker.settle();
    expectBooksBalance(v.broker.statistics());
}
}  // namespace
}  // namespace specplan::validity
