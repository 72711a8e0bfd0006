// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/VirtualExecutor.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "FakeChecker.h"

namespace specplan::validity
{
namespace
{
using test::FakeChecker;
using test::stateCheck;

constexpr std::chrono::milliseconds kPatience{1};
constexpr std::chrono::milliseconds kNoWait{0};

/// A check of node n lasts n seconds.
VirtualExecutor makeExecutor(Checker& checker, unsigned workers)
{
    return {checker, workers, [](CheckId check, bool) { return static_cast<double>(check.node()); }};
}

std::vector<std::uint32_t> collected(VirtualExecutor& executor, std::chrono::milliseconds patience)
{
    std::vector<Completion> completions;
    executor.collect(completions, patience);
    std::vector<std::uint32_t> nodes;
    for (const Completion& completion : completions)
        nodes.push_back(completion.check.node());
    return nodes;
}

using Nodes = std::vector<std::uint32_t>;

TEST(VirtualExecutor, ChecksEndWhenTheirWorkersAreDone)
{
    FakeChecker checker;
    VirtualExecutor executor = makeExecutor(checker, 2);
    EXPECT_EQ(executor.freeWorkers(), 2U);
    for (const std::uint32_t node : {5U, 2U, 4U})
        executor.submit(stateCheck(node), Urgency::Speculative);
    EXPECT_EQ(executor.freeWorkers(), 0U);
    EXPECT_EQ(collected(executor, kNoWait), Nodes{}) << "time stands still until somebody waits";
    EXPECT_EQ(collected(executor, kPatience), Nodes{2});
    EXPECT_EQ(executor.now(), 2.0);
    EXPECT_EQ(collected(executor, kPatience), Nodes{5});
    EXPECT_EQ(executor.now(), 5.0);
    EXPECT_EQ(collected(executor, kPatience), Nodes{4}) << "began at 2, when the first worker fell free";
    EXPECT_EQ(executor.now(), 6.0);
    EXPECT_FALSE(executor.busy());
    EXPECT_EQ(collected(executor, kPatience), Nodes{}) << "nothing to wait for";
    EXPECT_EQ(executor.now(), 6.0);
}

TEST(VirtualExecutor, ThoseThatEndTogetherComeInTheOrderOfTheirStart)
{
    FakeChecker checker;
    VirtualExecutor executor(checker, 3, [](CheckId, bool) { return 1.0; });
    for (const std::uint32_t node : {9U, 3U, 7U})
        executor.submit(stateCheck(node), Urgency::Speculative);
    EXPECT_EQ(collected(executor, kPatience), (Nodes{9, 3, 7}));
}

TEST(VirtualExecutor, DemandedChecksOvertakeQueuedOnes)
{
    FakeChecker checker;
    VirtualExecutor executor(checker, 1, [](CheckId, bool) { return 1.0; });
    executor.submit(stateCheck(1), Urgency::Speculative);
    executor.submit(stateCheck(2), Urgency::Speculative);
    executor.submit(stateCheck(3), Urgency::Speculative);
    executor.submit(stateCheck(4), Urgency::Demanded);
    executor.promote(stateCheck(3));
    executor.promote(stateCheck(1));  // runs already: nothing to do
    Nodes order;
    while (executor.busy())
        for (const std::uint32_t node : collected(executor, kPatience))
            order.push_back(node);
    EXPECT_EQ(order, (Nodes{1, 4, 3, 2}));
}

TEST(VirtualExecutor, QueuedChecksCanBeTakenBack)
{
    FakeChecker checker;
    VirtualExecutor executor(checker, 1, [](CheckId, bool) { return 1.0; });
    for (const std::uint32_t node : {1U, 2U, 3U})
        executor.submit(stateCheck(node), Urgency::Speculative);
    std::vector<CheckId> dropped;
    executor.cancelQueued(dropped);
    EXPECT_EQ(dropped, (std::vector<CheckId>{stateCheck(2), stateCheck(3)}));
    EXPECT_EQ(collected(executor, kPatience), Nodes{1});
    EXPECT_FALSE(executor.busy());
    EXPECT_EQ(checker.calls, 1);
}

TEST(VirtualExecutor, CostMayDependOnTheVerdict)
{
    FakeChecker checker;
    VirtualExecutor executor(checker, 2, [](CheckId, bool valid) { return valid ? 10.0 : 1.0; });
    executor.submit(stateCheck(2), Urgency::Speculative);
    executor.submit(stateCheck(3), Urgency::Speculative);
    EXPECT_EQ(collected(executor, kPatience), Nodes{3});
    EXPECT_EQ(executor.now(), 1.0);
}

TEST(VirtualExecutor, HasNoWorkerInTheCallingThread)
{
    FakeChecker checker;
    VirtualExecutor executor = makeExecutor(checker, 2);
    try
    {
        (void)executor.runHere(stateCheck(1));
        ADD_FAILURE() << "it ran one";
    }
    catch (const std::logic_error& error)
    {
        EXPECT_STREQ(error.what(), "a virtual executor has no worker in the calling thread");
    }
}
}  // namespace
}  // namespace specplan::validity
