// SPDX-License-Identifier: BSD-3-Clause
// Who runs which check, on a simulated pool where the search thread is one of the workers.
#include <gtest/gtest.h>

#include "FakeChecker.h"
#include "specplan/validity/Broker.h"
#include "specplan/validity/SimulatedPool.h"

namespace specplan::validity
{
namespace
{
using test::FakeChecker;
using test::stateCheck;

CheckId motionCheck(std::uint32_t motion)
{
    return CheckId::ofMotion(motion);
}

/// Names one motion after the other, and thinks for as long as the test says.
class MotionSource : public CheckSource
{
public:
    explicit MotionSource(double& clock) : clock_(clock)
    {
    }

    void propose(std::size_t count, std::vector<CheckId>& out) override
    {
        for (; count > 0 && next < last; --count)
        {
            clock_ += thought;
            out.push_back(motionCheck(next++));
        }
    }

    void proposeAtHand(std::size_t count, std::vector<CheckId>& out) override
    {
        for (; count > 0 && nextAtHand < lastAtHand; --count)
            out.push_back(motionCheck(nextAtHand++));
    }

    [[nodiscard]] bool keepsAsking() const noexcept override
    {
        return true;
    }

    void learned(CheckId check, bool) override
    {
        heard.push_back(check);
    }

    void missed() override
    {
        ++rests;
    }

    double thought = 0.0;
    std::uint32_t next = 0;
    std::uint32_t last = 0;
    std::uint32_t nextAtHand = 0;
    std::uint32_t lastAtHand = 0;
    int rests = 0;
    std::vector<CheckId> heard;

private:
    double& clock_;
};

class BrokerOnPool : public testing::Test
{
protected:
    SimulatedPool::Timing timing(double handOver = 0.0)
    {
        SimulatedPool::Timing timing;
        timing.ofCheck = [this](CheckId check, bool) { return check.isMotion() ? ofMotion : ofState; };
        timing.ofSearch = [this] { return work; };
        timing.handOver = handOver;
        timing.wake = 0.0;
        return timing;
    }

    void demand(std::initializer_list<CheckId> checks)
    {
        EXPECT_TRUE(broker.demand(std::vector<CheckId>(checks)));
    }

    /// Checks take 20 µs, and the source thinks for so long about each that nobody will ask for.
    void thinkInVain(double seconds)
    {
        broker.setWarmUp(0.0);
        ofMotion = 20e-6;
        source.thought = seconds;
        source.next = 1000000;
        source.last = 2000000;
        broker.setSource(&source);
    }

    double ofState = 1e-3;
    double ofMotion = 1e-3;
    double work = 0.0;  ///< seconds that the search has worked
    FakeChecker checker;
    SimulatedPool pool{checker, 2, timing()};
    Broker broker{pool};
    MotionSource source{work};
};

TEST_F(BrokerOnPool, TheSearchThreadKeepsOneCheckForItself)
{
    broker.setWarmUp(0.0);
    demand({stateCheck(0)});  // to see what one costs
    demand({stateCheck(2)});
    EXPECT_DOUBLE_EQ(broker.now(), 2e-3);
    EXPECT_EQ(broker.statistics().usedInline, 2U) << "nobody is woken for one check";
    demand({stateCheck(4), stateCheck(6)});
    EXPECT_DOUBLE_EQ(broker.now(), 3e-3);
    EXPECT_EQ(broker.statistics().usedInline, 3U);
    EXPECT_EQ(broker.statistics().usedAfterWait, 1U);
}

TEST_F(BrokerOnPool, OneOutlierDoesNotFlipTheModeButALastingChangeDoes)
{
    broker.setWarmUp(0.0);
    std::uint32_t node = 0;
    const auto handedOut = [&](double seconds, int pairs)
    {
        ofState = seconds;
        const std::uint64_t before = broker.statistics().speculativeChecks + broker.statistics().usedAfterWait;
        for (; pairs > 0; --pairs, node += 2)
            demand({stateCheck(2 * node), stateCheck(2 * node + 2)});
        return broker.statistics().speculativeChecks + broker.statistics().usedAfterWait - before;
    };
    EXPECT_EQ(handedOut(0.5e-6, 50), 0U);
    ofState = 2e-3;
    demand({stateCheck(1000000)});
    EXPECT_EQ(handedOut(0.5e-6, 50), 0U) << "after an outlier";
    EXPECT_GE(handedOut(100e-6, 40), 20U) << "a lasting change";
    handedOut(0.5e-6, 60);
    EXPECT_EQ(handedOut(0.5e-6, 50), 0U) << "and back again";
}

TEST_F(BrokerOnPool, AFewLongChecksAmongManyShortOnesAreHandedOut)
{
    broker.setWarmUp(0.0);
    for (std::uint32_t round = 0; round < 300; ++round)
    {
        ofState = 0.5e-6;
        for (std::uint32_t k = 0; k < 4; ++k)
            demand({stateCheck(20 * round + 2 * k)});
        ofState = 1e-3;
        demand({stateCheck(20 * round + 8), stateCheck(20 * round + 10)});
    }
    EXPECT_GE(broker.statistics().usedAfterWait, 200U);
}

TEST_F(BrokerOnPool, NobodyElseIsWokenForAMillisecondOfChecks)
{
    ofState = 60e-6;
    for (std::uint32_t node = 0; node < 18; node += 2)
        demand({stateCheck(2 * node), stateCheck(2 * node + 2)});
    EXPECT_EQ(broker.statistics().usedInline, 18U);
    EXPECT_NEAR(broker.now(), 1.08e-3, 1e-9);
    demand({stateCheck(100), stateCheck(102)});
    EXPECT_EQ(broker.statistics().usedInline, 19U);
    EXPECT_NEAR(broker.now(), 1.14e-3, 1e-9);
}

TEST_F(BrokerOnPool, LongChecksAreHandedOutFromTheSecondOn)
{
    ofState = 150e-6;
    demand({stateCheck(0)});
    demand({stateCheck(2), stateCheck(4)});
    EXPECT_EQ(broker.statistics().usedInline, 2U);
    EXPECT_NEAR(broker.now(), 0.3e-3, 1e-9);
}

TEST_F(BrokerOnPool, WhatIsCheaperThanHandingOverRunsAheadHere)
{
    broker.setWarmUp(0.0);
    ofState = 1e-6;
    demand({stateCheck(0)});
    demand({motionCheck(0)});
    broker.setSource(&source);
    EXPECT_TRUE(broker.prefetch(stateCheck(2)));
    EXPECT_EQ(broker.verdict(stateCheck(2)), Verdict::Valid) << "known at once";
    EXPECT_EQ(source.heard, std::vector<CheckId>{stateCheck(2)});
    EXPECT_TRUE(broker.prefetch(motionCheck(1)));
    EXPECT_EQ(broker.verdict(motionCheck(1)), Verdict::InFlight);
    demand({stateCheck(2)});
    EXPECT_EQ(broker.statistics().speculativeUsed, 1U);
    broker.settle();
}

TEST_F(BrokerOnPool, ASourceThatThinksForTooLongRestsLongerEachTime)
{
    thinkInVain(30e-6);
    std::vector<double> rests;
    for (std::uint32_t motion = 0; motion < 200000; motion += 2)
    {
        const int before = source.rests;
        demand({motionCheck(motion), motionCheck(motion + 1)});
        if (source.rests > before)
            rests.push_back(broker.now());
    }
    ASSERT_GE(rests.size(), 4U);
    for (std::size_t i = 2; i < rests.size(); ++i)
        EXPECT_GT(rests[i] - rests[i - 1], 1.5 * (rests[i - 1] - rests[i - 2]));
    broker.settle();
}

/// As on a machine whose processors are busy with something else.
TEST_F(BrokerOnPool, WhereHandingOverCostsMoreThanCheckingNobodyIsWoken)
{
    constexpr std::uint32_t kCount = 20000;
    ofMotion = 20e-6;
    for (const bool atHand : {false, true})
    {
        SimulatedPool busy(checker, 2, timing(40e-6));
        Broker asking(busy);
        asking.setWarmUp(0.0);
        MotionSource naming(work);
        (atHand ? naming.lastAtHand : naming.last) = 2 * kCount;
        asking.setSource(&naming);
        for (std::uint32_t motion = 0; motion < 2 * kCount; motion += 2)
            EXPECT_TRUE(asking.demand(std::vector{motionCheck(motion), motionCheck(motion + 1)}));
        EXPECT_LT(asking.now(), 1.04 * (2 * kCount * ofMotion)) << atHand;
        asking.settle();
    }
}

TEST_F(BrokerOnPool, WhatIsAtHandComesBeforeThinkingAndAlsoDuringRests)
{
    thinkInVain(1e-3);
    source.nextAtHand = 5;
    source.lastAtHand = 30000;
    for (std::uint32_t motion = 0; motion < 20000; ++motion)
        demand({motionCheck(motion)});
    EXPECT_EQ(source.next, 1000000U) << "no need to think";
    EXPECT_EQ(source.rests, 0);
    EXPECT_LT(broker.now(), 0.6 * (20000 * ofMotion));

    source.nextAtHand = source.lastAtHand = 0;
    for (std::uint32_t motion = 50000; source.rests == 0; ++motion)
    {
        ASSERT_LT(motion, 60000U);
        demand({motionCheck(motion)});
    }
    source.nextAtHand = 30000;
    source.lastAtHand = 30001;
    for (std::uint32_t motion = 40000; motion < 40100; ++motion)
        demand({motionCheck(motion)});
    EXPECT_TRUE(isKnown(broker.verdict(motionCheck(30000))));
    EXPECT_EQ(source.rests, 1);
    broker.settle();
}

TEST_F(BrokerOnPool, WhereTheSearchThinksForLongWorkersAreGivenMoreToDo)
{
    broker.setWarmUp(0.0);
    ofMotion = 20e-6;
    source.nextAtHand = 100000;
    source.lastAtHand = 200000;
    broker.setSource(&source);
    for (std::uint32_t motion = 0; motion < 1000; ++motion)
    {
        demand({motionCheck(motion)});
        work += 300e-6;
    }
    EXPECT_GT(broker.statistics().checksRun, 1000U * 14U) << "the worker has 15 a time";
    broker.settle();
}

TEST_F(BrokerOnPool, WhatPassesBetweenTwoSearchesIsNoThought)
{
    broker.setWarmUp(0.0);
    ofMotion = 20e-6;
    demand({motionCheck(0)});
    demand({motionCheck(1), motionCheck(2)});
    const unsigned room = pool.room();
    EXPECT_LT(room, 10U);
    broker.settle();
    work += 1000.0;
    demand({motionCheck(3), motionCheck(4)});
    EXPECT_EQ(pool.room(), room);
    work += 1.0;
    demand({motionCheck(5), motionCheck(6)});
    EXPECT_EQ(pool.room(), 48U) << "that was a thought";
}

TEST_F(BrokerOnPool, AFeedInTheMidstOfALongThoughtKeepsWorkersGoing)
{
    broker.setWarmUp(0.0);
    source.nextAtHand = 100000;
    source.lastAtHand = 200000;
    demand({motionCheck(0)});
    broker.feed();
    EXPECT_EQ(broker.statistics().speculativeChecks, 0U) << "there is no source";
    broker.setSource(&source);
    demand({motionCheck(1), motionCheck(2)});
    const std::uint64_t before = broker.statistics().speculativeChecks;
    broker.feed();
    EXPECT_EQ(broker.statistics().speculativeChecks, before) << "nobody has run dry";
    for (int portions = 0; portions < 10; ++portions)
    {
        work += 20e-3;
        broker.feed();
    }
    EXPECT_GE(broker.statistics().speculativeChecks, before + 20U);
    broker.settle();
}

TEST_F(BrokerOnPool, AFeedReachesWorkersThatHaveNothingLeftAlsoDuringRests)
{
    thinkInVain(1e-3);
    for (std::uint32_t motion = 0; source.rests == 0; ++motion)
    {
        ASSERT_LT(motion, 10000U);
        demand({motionCheck(motion)});
    }
    broker.settle();
    const std::uint32_t next = source.next;
    source.nextAtHand = 30000;
    source.lastAtHand = 40000;
    broker.feed();
    EXPECT_GT(source.nextAtHand, 30000U);
    EXPECT_EQ(source.next, next) << "thinking rests";
    broker.settle();
}

TEST_F(BrokerOnPool, ASourceThatPaysNeverRests)
{
    broker.setWarmUp(0.0);
    ofMotion = 20e-6;
    source.thought = 3e-6;
    source.last = 200000;
    broker.setSource(&source);
    for (std::uint32_t motion = 0; motion < 20000; ++motion)
        demand({motionCheck(motion)});
    EXPECT_EQ(source.rests, 0);
    EXPECT_LT(broker.now(), 0.62 * (20000 * ofMotion));
    broker.settle();
}
}  // namespace
}  // namespace specplan::validity
