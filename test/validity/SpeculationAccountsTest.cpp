// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/SpeculationAccounts.h"

#include <gtest/gtest.h>

#include "FakeChecker.h"
#include "specplan/validity/SimulatedPool.h"

namespace specplan::validity
{
namespace
{
class SpeculationAccountsTest : public testing::Test
{
protected:
    static constexpr double kCheck = 22.5e-6;  ///< of which 20 µs are a gain
    static constexpr double kGain = 20e-6;

    SimulatedPool::Timing timing()
    {
        SimulatedPool::Timing timing;
        timing.ofCheck = [](CheckId, bool) { return 1.0; };
        timing.ofSearch = [this] { return clock; };
        return timing;
    }

    /// So many checks were handed over that the source had to think of.
    void gain(int checks, double times = 1.0)
    {
        for (int i = 0; i < checks; ++i)
            accounts.addGain(kCheck, true, times);
    }

    double clock = 0.0;
    test::FakeChecker checker;
    SimulatedPool executor{checker, 2, timing()};
    SpeculationAccounts accounts{executor};
};

TEST_F(SpeculationAccountsTest, NothingIsJudgedBeforeItHasCostSomething)
{
    accounts.addThought(1e-3);
    accounts.addHandOver(0.9e-3);
    EXPECT_FALSE(accounts.settle(0.0));
    EXPECT_FALSE(accounts.sourceRests());
    accounts.addThought(0.2e-3);
    EXPECT_TRUE(accounts.settle(0.0));
    EXPECT_TRUE(accounts.sourceRests());
}

TEST_F(SpeculationAccountsTest, WhatIsSpentInVainIsFollowedByARestLongerEachTime)
{
    double rest = 30e-3;  // ten times what was spent
    for (int times = 0; times < 3; ++times)
    {
        accounts.addThought(3e-3);
        EXPECT_TRUE(accounts.settle(0.0));
        clock += 0.99 * rest;
        EXPECT_TRUE(accounts.sourceRests());
        clock += 0.02 * rest;
        EXPECT_FALSE(accounts.sourceRests());
        EXPECT_FALSE(accounts.workersRest()) << "handing over was not what cost so much";
        accounts.addThought(1.0);
        EXPECT_FALSE(accounts.settle(0.0)) << "to begin anew takes long, and says nothing";
        rest *= 2.0;
    }
}

TEST_F(SpeculationAccountsTest, ThinkingThatPaysIsForgottenAndSoAreEarlierRests)
{
    accounts.addThought(3e-3);
    EXPECT_TRUE(accounts.settle(0.0));
    accounts.addThought(0.0);
    clock = 1.0;
    accounts.addThought(3e-3);
    gain(static_cast<int>(3e-3 / (0.8 * kGain)) + 1);
    EXPECT_FALSE(accounts.settle(0.0));
    EXPECT_FALSE(accounts.sourceRests());

    accounts.addThought(3e-3);
    EXPECT_TRUE(accounts.settle(0.0));
    clock += 0.99 * 30e-3;
    EXPECT_TRUE(accounts.sourceRests());
    clock += 0.02 * 30e-3;
    EXPECT_FALSE(accounts.sourceRests()) << "not twice as long";
}

TEST_F(SpeculationAccountsTest, GainsThatComeToNothingAreTakenBack)
{
    accounts.addThought(3e-3);
    gain(1000);
    gain(1000, -1.0);
    EXPECT_TRUE(accounts.settle(0.0));
}

TEST_F(SpeculationAccountsTest, ThinkingIsPaidByItsOwnChecksHandingOverByAll)
{
    accounts.addThought(3e-3);
    for (int i = 0; i < 1000; ++i)
        accounts.addGain(kCheck, false, 1.0);
    EXPECT_TRUE(accounts.settle(0.0));
    EXPECT_FALSE(accounts.workersRest());
    clock = 1.0;
    accounts.addHandOver(3e-3);
    for (int i = 0; i < 1000; ++i)
        accounts.addGain(kCheck, false, 1.0);
    EXPECT_FALSE(accounts.settle(0.0));
}

TEST_F(SpeculationAccountsTest, WhereHandingOverCostsTooMuchWorkersRestToo)
{
    accounts.addHandOver(3e-3);
    EXPECT_TRUE(accounts.settle(0.0));
    EXPECT_TRUE(accounts.workersRest());
    clock = 1.0;
    EXPECT_FALSE(accounts.workersRest());
}

TEST_F(SpeculationAccountsTest, AHundredthOfAllChecksMayGoInVain)
{
    accounts.addThought(3e-3);
    EXPECT_FALSE(accounts.settle(0.31));
    EXPECT_TRUE(accounts.settle(0.29));
}
}  // namespace
}  // namespace specplan::validity
