// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison.h"

#include <gtest/gtest.h>

#include "Command.h"

namespace specplan::command
{
namespace
{
const RunRecord kWhole{"solved", false, 7, {1, 2, 3}, {2.5, 2.0}, {{0.0}, {1.0}}};

RunRecord stoppedAfter(std::size_t expansions, std::size_t costs)
{
    RunRecord record = kWhole;
    record.status = "timeout";
    record.stopped = true;
    record.orderHash = 0;
    record.expansions.resize(expansions);
    record.costs.resize(costs);
    record.path.clear();
    return record;
}

TEST(DifferenceOf, IsNoneOfEqualRuns)
{
    EXPECT_EQ(differenceOf(kWhole, kWhole), "");
    EXPECT_EQ(differenceOf(stoppedAfter(2, 1), kWhole), "");
    EXPECT_EQ(differenceOf(kWhole, stoppedAfter(2, 0)), "");
    EXPECT_EQ(differenceOf(stoppedAfter(2, 1), stoppedAfter(3, 2)), "");
    EXPECT_EQ(differenceOf(stoppedAfter(0, 0), kWhole), "");
}

TEST(DifferenceOf, NamesWhatDiffers)
{
    RunRecord other = kWhole;
    other.status = "infeasible";
    EXPECT_EQ(differenceOf(other, kWhole), "its status is infeasible, that of the sequential run solved");
    other = kWhole;
    other.expansions[1] = 9;
    EXPECT_EQ(differenceOf(other, kWhole), "its expansion 2 is not that of the sequential run");
    other = kWhole;
    other.expansions.push_back(4);
    EXPECT_EQ(differenceOf(other, kWhole), "the sequential run ended after 3 expansions, and it went on");
    EXPECT_EQ(differenceOf(kWhole, other), "it ended after 3 expansions, and the sequential run went on");
    other = kWhole;
    other.orderHash = 8;
    EXPECT_EQ(differenceOf(other, kWhole), "its order hash is not that of the sequential run");
    other = kWhole;
    other.costs[1] = 2.25;
    EXPECT_EQ(differenceOf(other, kWhole), "its path 2 costs 2.25, that of the sequential run 2");
    other = kWhole;
    other.costs.pop_back();
    EXPECT_EQ(differenceOf(other, kWhole), "it found 1 paths, the sequential run 2");
    other = kWhole;
    other.path[0][0] = 0.5;
    EXPECT_EQ(differenceOf(other, kWhole), "its path is not that of the sequential run");
}

TEST(DifferenceOf, SeesThroughStops)
{
    RunRecord other = stoppedAfter(2, 1);
    other.expansions[0] = 9;
    EXPECT_EQ(differenceOf(other, kWhole), "its expansion 1 is not that of the sequential run");
    other = stoppedAfter(2, 1);
    other.costs[0] = 3.0;
    EXPECT_EQ(differenceOf(other, kWhole), "its path 1 costs 3, that of the sequential run 2.5");
    other = kWhole;
    other.expansions.push_back(4);
    other.stopped = true;
    EXPECT_EQ(differenceOf(kWhole, other), "it ended after 3 expansions, and the sequential run went on");
}

TEST(Verify, ComparesWithTheSequentialRun)
{
    const std::string city = test::scene("city-64.map");
    for (const char* how : {"--threads 4 --check-latency 20us", "--threads 64 --executor virtual",
                            "--threads 3 --weight 5", "--threads 4 --evaluation lazy --check-latency 20us"})
    {
        const test::Outcome outcome = test::call("plan " + city + " --verify --json " + how);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        const nlohmann::json run = outcome.json();
        const nlohmann::json& verification = run["verification"];
        EXPECT_EQ(verification["same"], true) << how;
        EXPECT_EQ(verification["compared"], "all");
        EXPECT_EQ(verification["expansions"], run["expansions"]);
        EXPECT_EQ(verification["sequential"]["order_hash"], run["order_hash"]);
        EXPECT_EQ(verification["sequential"]["threads"], 1);
        EXPECT_EQ(verification["sequential"]["policy"], "none");
    }
    const test::Outcome table = test::call("plan " + city + " --verify");
    EXPECT_NE(
        table.out.find("verified            status, path, cost and all 1623 expansions are those of sequential A*"),
        std::string::npos)
        << table.out;
}

TEST(Verify, OfAStoppedSearchComparesWhatItDid)
{
    const std::string map = test::scene("city-256.map");
    const test::Outcome outcome =
        test::call("plan " + map + " --threads 4 --check-busy 100us --time-limit 150ms --verify --json");
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    const nlohmann::json run = outcome.json();
    EXPECT_EQ(run["status"], "timeout");
    EXPECT_EQ(run["verification"]["same"], true);
    EXPECT_EQ(run["verification"]["compared"], "first expansions");
    EXPECT_EQ(run["verification"]["expansions"], run["expansions"]);
}

TEST(Verify, AnytimeRunsAreComparedPathByPath)
{
    const test::Outcome outcome =
        test::call("plan " + test::scene("city-64.map") + " --weight 20 --anytime --threads 4 --verify --json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json run = outcome.json();
    EXPECT_EQ(run["verification"]["same"], true);
    EXPECT_EQ(run["verification"]["sequential"]["improvements"].size(), run["improvements"].size());
}

TEST(Verify, IsForOurPlannerAlone)
{
    for (const char* other : {" --planner RRT", " --predict 2"})
        EXPECT_EQ(test::call("plan " + test::scene("city-64.map") + " --verify" + other).status, 2) << other;
}
}  // namespace
}  // namespace specplan::command
