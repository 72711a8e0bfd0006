// SPDX-License-Identifier: BSD-3-Clause
// The command as its users meet it: exit status, one line for bad input, files all or nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "Command.h"

namespace specplan::test
{
namespace
{
const std::string kSmall = "type octile\nheight 2\nwidth 3\nmap\n.@.\n.@.\n";

TEST(Command, PlanPrintsATableOrJson)
{
    const Outcome table = call("plan " + kCity + " --threads 1");
    EXPECT_EQ(table.status, 0);
    EXPECT_NE(table.out.find("status              solved"), std::string::npos) << table.out;
    EXPECT_EQ(table.err, "");

    const Outcome json = call("plan " + kCity + " --threads 4 --check-latency 10us --json");
    EXPECT_EQ(json.status, 0);
    EXPECT_EQ(json.err, "");
    const nlohmann::json run = json.json();
    for (const char* key : {"status",           "cost",           "expansions",
                            "checks_used",      "checks_total",   "speculative_checks",
                            "speculative_used", "accuracy",       "coverage",
                            "timeliness",       "wall_time_s",    "search_time_s",
                            "wait_time_s",      "virtual_time_s", "sequential_time_s",
                            "speedup",          "efficiency",     "threads",
                            "policy",           "weight",         "evaluation",
                            "order_hash"})
        EXPECT_TRUE(run.contains(key)) << key;
    EXPECT_EQ(run["status"], "solved");
    EXPECT_EQ(run["threads"], 4);
}

TEST(Command, OrderHashIsTheSameForEveryPolicyAndExecutor)
{
    const std::string hash = call("plan " + kCity + " --threads 1 --json").json()["order_hash"];
    for (const char* how :
         {"--threads 3 --policy none", "--threads 3 --policy direction", "--threads 3",
          "--threads 64 --executor virtual", "--threads 64 --executor virtual --policy direction --barrier"})
        EXPECT_EQ(call("plan " + kCity + " --json " + how).json()["order_hash"], hash) << how;
    EXPECT_NE(call("plan " + kCity + " --json --weight 2").json()["order_hash"], hash);
}

TEST(Command, VirtualTimeIsRepeatableAndTheSumOfTheChecksForOneWorker)
{
    const std::string how = "plan " + kCity + " --executor virtual --check-latency 5ms --json --threads ";
    const nlohmann::json one = call(how + "1").json();
    // The goal's own state is checked before the search.
    EXPECT_NEAR(one["virtual_time_s"].get<double>(), (one["checks_used"].get<double>() - 1.0) * 5e-3, 1e-6);
    const nlohmann::json many = call(how + "32").json();
    EXPECT_EQ(many["virtual_time_s"], call(how + "32").json()["virtual_time_s"]);
    EXPECT_LT(many["virtual_time_s"], one["virtual_time_s"]);
}

TEST(Command, WritesPictureTraceAndPath)
{
    const TemporaryFolder folder;
    ASSERT_EQ(call("plan " + kCity + " --threads 4 --svg '" + folder / "a.svg" + "' --trace '" + folder / "a.json" +
                   "' --path '" + folder / "a.path" + "'")
                  .status,
              0);
    EXPECT_EQ(folder.files(), 3);
    const std::string svg = folder.read("a.svg");
    EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
    EXPECT_NE(svg.find("<polyline"), std::string::npos);
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
    const nlohmann::json trace = nlohmann::json::parse(folder.read("a.json"));
    EXPECT_EQ(trace["expanded"].size(), trace["expansions"]);
    EXPECT_EQ(trace["map"].size(), 64U);
    EXPECT_EQ(trace["path"].front(), trace["start"]);
    EXPECT_EQ(trace["path"].back(), trace["goal"]);
    EXPECT_EQ(trace["expanded"].back(), trace["goal"]);
    std::istringstream path(folder.read("a.path"));
    std::size_t states = 0;
    for (double x = 0.0, y = 0.0; path >> x >> y; ++states)
        EXPECT_TRUE(trace["path"][states] == (nlohmann::json{static_cast<int>(x), static_cast<int>(y)})) << states;
    EXPECT_EQ(states, trace["path"].size());
}

TEST(Command, PredictsFromOneRunHowLongMoreThreadsTake)
{
    const TemporaryFolder folder;
    const Outcome outcome =
        call("plan " + kCity + " --check-latency 300us --predict 1..8,12 --json --csv '" + folder / "a.csv" +
             "' --plot '" + folder / "a.svg" + "' --trace '" + folder / "checks.csv" + "'");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const nlohmann::json run = outcome.json();
    EXPECT_EQ(run["threads"], 1);
    const nlohmann::json& predictions = run["predictions"];
    const std::vector<unsigned> threads{1, 2, 4, 8, 12};
    ASSERT_EQ(predictions.size(), threads.size());
    for (std::size_t i = 0; i < threads.size(); ++i)
    {
        const nlohmann::json& row = predictions[i];
        EXPECT_EQ(row["threads"], threads[i]);
        EXPECT_EQ(row["order_hash"], run["order_hash"]);
        EXPECT_NEAR(row["virtual_time_s"].get<double>() * row["speedup"].get<double>(),
                    run["wall_time_s"].get<double>(), 1e-9);
        EXPECT_GT(row["speedup"].get<double>(), i == 0 ? 0.99 : 1.1);
        EXPECT_LT(row["speedup"].get<double>(), 1.02 * threads[i]);
    }
    EXPECT_EQ(predictions[0]["speedup"], 1.0);
    const std::string csv = folder.read("a.csv");
    EXPECT_EQ(std::ranges::count(csv, '\n'), 6) << csv;
    EXPECT_EQ(folder.read("a.svg").rfind("<?xml", 0), 0U);
    const std::string checks = folder.read("checks.csv");
    EXPECT_EQ(checks.rfind("kind,valid,used,start_s,duration_s,worker,from,to\nstate,", 0), 0U);
    EXPECT_EQ(std::ranges::count(checks, '\n'), run["checks_total"].get<std::ptrdiff_t>() - 1)
        << "a heading, and all checks but those of start and goal, which come before the search";
    EXPECT_EQ(folder.files(), 3);
}

TEST(Command, PredictionsAreATableToo)
{
    const Outcome outcome = call("plan " + kCity + " --check-latency 50us --predict 2,32");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("\n   runahead       2     solved"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\n   runahead      32     solved"), std::string::npos) << outcome.out;
}

TEST(Command, NothingIsPredictedFromASearchThatWasStopped)
{
    const TemporaryFolder folder;
    const Outcome outcome = call("plan " + kCity + " --check-latency 5ms --time-limit 50ms --json --predict 2 --csv '" +
                                 folder / "a.csv" + "'");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_FALSE(outcome.json().contains("predictions"));
    EXPECT_EQ(
        outcome.err,
        "specplan: warning: --predict: nothing is predicted from a search that did not come to its end (timeout)\n");
    EXPECT_EQ(folder.files(), 0) << "no predictions, no file";
}

TEST(Command, AnytimeTellsHowTheCostFell)
{
    const nlohmann::json run = call("plan " + kCity + " --weight 20 --anytime --json").json();
    const nlohmann::json& improvements = run["improvements"];
    ASSERT_GT(improvements.size(), 1U);
    for (std::size_t i = 1; i < improvements.size(); ++i)
    {
        EXPECT_LT(improvements[i]["cost"], improvements[i - 1]["cost"]);
        EXPECT_GE(improvements[i]["time_s"], improvements[i - 1]["time_s"]);
    }
    EXPECT_EQ(improvements.back()["cost"], run["cost"]);
    EXPECT_EQ(run["weight"], 1.0) << "down to the best there is";
    const nlohmann::json once = call("plan " + kCity + " --weight 20 --json").json();
    EXPECT_EQ(once["cost"], improvements.front()["cost"]);
    EXPECT_EQ(once["weight"], 20.0);
    EXPECT_FALSE(once.contains("improvements"));
}

TEST(Command, SpeedupWritesTableCsvAndPlot)
{
    const TemporaryFolder folder;
    const Outcome outcome =
        call("speedup " + kCity + " --threads 1,2,8 --policies none,runahead --executor virtual --csv '" +
             folder / "a.csv" + "' --plot '" + folder / "a plot.svg" + "'");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const std::string csv = folder.read("a.csv");
    EXPECT_EQ(std::ranges::count(csv, '\n'), 7) << csv;
    EXPECT_EQ(csv.rfind("problem,status,cost,", 0), 0U);
    EXPECT_EQ(folder.read("a plot.svg").rfind("<?xml", 0), 0U);
    EXPECT_EQ(folder.files(), 2);
}

TEST(Command, SpeedupTakesSeveralProblems)
{
    const nlohmann::json results = call("speedup " + kCity + " " + scene("maze-64.map") +
                                        " --threads 1,16 --policies direction,runahead --executor virtual --json")
                                       .json()["results"];
    ASSERT_EQ(results.size(), 8U);
    for (const nlohmann::json& row : results)
    {
        EXPECT_EQ(row["status"], "solved");
        EXPECT_NEAR(row["efficiency"].get<double>() * row["threads"].get<double>(), row["speedup"].get<double>(), 1e-9);
    }
    EXPECT_EQ(results[0]["speedup"], 1.0);
    EXPECT_GT(results[3]["speedup"], results[1]["speedup"]) << "run-ahead is ahead of the paper's rule";
    EXPECT_NE(results[0]["order_hash"], results[4]["order_hash"]);
}

TEST(Command, UnsolvableProblemsEndWithOne)
{
    const TemporaryFolder folder;
    const std::string map = folder.write("a.map", kSmall);
    const Outcome outcome = call("plan " + map + " --start 0,0 --goal 2,1 --json --path '" + folder / "path" + "'");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.json()["status"], "infeasible");
    EXPECT_TRUE(outcome.json()["cost"].is_null());
    EXPECT_EQ(folder.files(), 1) << "no path, no file";
    EXPECT_EQ(call("speedup " + map + " --start 0,0 --goal 2,1 --threads 1,2 --check-latency 1us").status, 1);
}

TEST(Command, TimeLimitEndsWithOne)
{
    const Outcome outcome = call("plan " + kCity + " --threads 2 --check-latency 5ms --time-limit 50ms --json");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.json()["status"], "timeout");
}

TEST(Command, HelpAndVersionEndWithZero)
{
    EXPECT_EQ(call("--help").status, 0);
    EXPECT_EQ(call("plan --help").status, 0);
    EXPECT_EQ(call("--version").status, 0);
}

struct BadCall
{
    const char* arguments;  ///< MAP: a map whose two halves have no way between them; OUT: a folder
    const char* complaint;  ///< part of it
};

void PrintTo(const BadCall& bad, std::ostream* out)
{
    *out << bad.arguments;
}

class BadCommand : public testing::TestWithParam<BadCall>
{
};

std::string filledIn(std::string text, const std::string& what, const std::string& by)
{
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

TEST_P(BadCommand, PrintsOneLineAndLeavesNoFile)
{
    const TemporaryFolder folder;
    const std::string map = folder.write("small.map", kSmall);
    const std::string arguments = filledIn(filledIn(GetParam().arguments, "MAP", map), "OUT", folder / ".");
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("specplan: ", 0), 0U) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().complaint), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.files(), 1) << "only the map is there";
}

INSTANTIATE_TEST_SUITE_P(
    All, BadCommand,
    testing::Values(
        BadCall{"", "expected a subcommand: plan, benchmark, speedup"},
        BadCall{"fly", "unknown subcommand 'fly'; expected plan, benchmark, speedup"}, BadCall{"plan", "PROBLEM"},
        BadCall{"plan none.map --start 0,0 --goal 1,1", "none.map: cannot be read"},
        BadCall{"plan OUT --start 0,0 --goal 1,1", "found a directory"},
        BadCall{"plan problem.cfg", "problem.cfg: cannot be read"},
        BadCall{"plan MAP", "small.map: a map needs --start x,y and --goal x,y, or --scen"},
        BadCall{"plan MAP --start 0,0", "--start and --goal together"},
        BadCall{"plan MAP --start 0:0 --goal 2,1", "--start: expected a cell x,y"},
        BadCall{"plan MAP --start 0,0,0 --goal 2,1", "--start: expected a cell x,y"},
        BadCall{"plan MAP --start 1,0 --goal 2,1", "start 1,0 is an obstacle"},
        BadCall{"plan MAP --start 0,0 --goal 3,1", "expected a goal inside the map of 3 x 2 cells, found goal 3,1"},
        BadCall{"plan MAP --scen none.scen", "none.scen: cannot be read"},
        BadCall{"plan MAP --scen MAP", "small.map:1: expected 'version 1'"},
        BadCall{"plan MAP --scen " SPECPLAN_SCENES_DIR "/city-64.map.scen", "is for a map of 64 x 64 cells"},
        BadCall{"plan " SPECPLAN_SCENES_DIR "/city-64.map --index 10", "--index: expected 0 to 9 or 'last'"},
        BadCall{"plan " SPECPLAN_SCENES_DIR "/city-64.map --index -1", "--index"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --threads two", "--threads"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --threads -1", "--threads"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --threads 5000", "--threads"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --weight 0.5", "--weight"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --weight nan", "weight"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --policy psychic", "psychic"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --cost gold", "gold"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --lookahead 0", "--lookahead"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --executor quantum", "quantum"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --evaluation sloppy", "--evaluation: sloppy not in"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --check-latency 5",
                "--check-latency: expected a duration such as 5ms"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --check-busy -5ms", "--check-busy"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --check-busy 1ms --check-latency 1ms", "excludes"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --time-limit soon", "--time-limit: expected a duration"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --svg OUT/none/a.svg", "a.svg: cannot be written"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --svg OUT/a.svg --path OUT", "cannot be written: it is a directory"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --colour red", "unknown option '--colour' of plan"},
        BadCall{"plan --colour=red", "unknown option '--colour' of plan"},
        BadCall{"--json plan MAP", "unknown option '--json'"},
        BadCall{"benchmark MAP MAP", "PROBLEM: expected one, found '"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict 0", "--predict: expected numbers from 1 to 4096"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict 8..2", "such as 1,2,4 or 1..256, found '8..2'"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict 1,,2", "--predict: expected numbers"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict 1..", "--predict: expected numbers"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict 1..5000", "--predict: expected numbers"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict many", "--predict: expected numbers"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict 2 --threads 2", "excludes"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict 2 --anytime", "excludes"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --csv OUT/a.csv", "requires --predict"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --predict 2 --csv OUT/none/a.csv", "a.csv: cannot be written"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --planner RRT --trace OUT/a.csv", "--trace: expected a name"},
        BadCall{"plan MAP MAP --start 0,0 --goal 0,1", "PROBLEM"},
        BadCall{"speedup MAP MAP --start 0,0 --goal 0,1", "expected a single PROBLEM"},
        BadCall{"plan MAP --start 0,0 --goal 0,1 --validity-resolution 0.01",
                "--validity-resolution: expected a .cfg problem with this, found "},
        BadCall{"speedup MAP --start 0,0 --goal 0,1 --threads 1,x", "--threads"},
        BadCall{"speedup MAP --start 0,0 --goal 0,1 --policies none,x", "--policies"},
        BadCall{"speedup MAP --start 0,0 --goal 0,1 --csv OUT/none/a.csv", "a.csv: cannot be written"}));
}  // namespace
}  // namespace specplan::test
