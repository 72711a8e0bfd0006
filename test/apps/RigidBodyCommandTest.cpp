// SPDX-License-Identifier: BSD-3-Clause
// The command on rigid-body problems: plan with pictures, and OMPL's Benchmark with its log.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <regex>

#include "CallAndInterrupt.h"
#include "Command.h"
#include "Replaced.h"
#include "fcl/RigidFixture.h"

namespace specplan::test
{
namespace
{
class RigidBodyCommand : public testing::Test
{
protected:
    [[nodiscard]] std::string problem(const std::string& text) const
    {
        return "'" + room_.folder.write("room.cfg", text) + "'";
    }

    [[nodiscard]] std::string file(const std::string& name) const
    {
        return "'" + room_.folder / name + "'";
    }

    RoomFolder room_;
};

TEST_F(RigidBodyCommand, APlannerThatCannotBeginIsNotATimeout)
{
    const Outcome outcome =
        call("plan " + problem(RoomFolder::spatial()) + " --planner 'SpeculativeAStar:spacing=1,2,3,4,5' --json");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.json()["status"], "crash");
}

TEST_F(RigidBodyCommand, PlanWritesPictureTraceAndPath)
{
    for (const bool planar : {true, false})
    {
        const Outcome outcome = call("plan " + problem(planar ? RoomFolder::planar() : RoomFolder::spatial()) +
                                     " --planner RRTConnect --json --svg " + file("a.svg") + " --trace " +
                                     file("a.json") + " --path " + file("a.path"));
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(outcome.json()["status"], "solved");
        EXPECT_EQ(outcome.json()["planner"], "RRTConnect");
        const std::string svg = room_.folder.read("a.svg");
        EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
        EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
        const std::regex line("<polyline");
        const auto views = std::distance(std::sregex_iterator(svg.begin(), svg.end(), line), std::sregex_iterator());
        EXPECT_EQ(views, planar ? 1 : 3) << "the path in each view";
        const nlohmann::json trace = nlohmann::json::parse(room_.folder.read("a.json"));
        EXPECT_EQ(trace["planar"], planar);
        EXPECT_EQ(trace["path"].front(), trace["start"]);
        EXPECT_EQ(trace["start"].size(), planar ? 3U : 7U);
        const std::string path = room_.folder.read("a.path");
        EXPECT_GE(std::ranges::count(path, '\n'), static_cast<std::ptrdiff_t>(trace["path"].size()));
    }
}

TEST_F(RigidBodyCommand, PlanRefinesUntilThereIsAPath)
{
    // A door hardly wider than the robot, halfway between two lines of the first lattice; they are 0.174 apart.
    problems::Mesh room = boxMesh({4.9, -0.2, 0.0}, {5.1, 3.008, 3.0});
    problems::addBox(room, {4.9, 3.428, 0.0}, {5.1, 10.2, 3.0});
    problems::addBox(room, {-0.2, -0.4, 0.0}, {10.2, -0.2, 3.0});
    problems::addBox(room, {-0.2, 10.2, 0.0}, {10.2, 10.4, 3.0});
    problems::writeObj(room_.folder / "room.obj", room);
    const std::string narrow = problem(
        "[problem]\nrobot = robot.obj\nworld = room.obj\nlongest_valid_segment_fraction = 0.005\n"
        "start.x = 2\nstart.y = 4\nstart.theta = 0\ngoal.x = 8\ngoal.y = 4\ngoal.theta = 0\n");
    const nlohmann::json found = call("plan " + narrow + " --json --threads 1").json();
    EXPECT_EQ(found["status"], "solved");
    EXPECT_GE(found["refinements"], 1);
    const nlohmann::json many = call("plan " + narrow + " --json --threads 4 --executor virtual").json();
    EXPECT_EQ(many["order_hash"], found["order_hash"]);
    EXPECT_EQ(many["refinements"], found["refinements"]);

    const nlohmann::json late = call("plan " + narrow + " --json --time-limit 1ms").json();
    EXPECT_EQ(late["status"], "timeout");
}

TEST_F(RigidBodyCommand, TheFilesTimeLimitIsThatOfPlan)
{
    const nlohmann::json run =
        call("plan " + problem(RoomFolder::planar()) + " --threads 1 --check-latency 5ms --json").json();
    EXPECT_EQ(run["status"], "timeout");
    EXPECT_NEAR(run["wall_time_s"].get<double>(), 2.0, 1.0);
}

TEST_F(RigidBodyCommand, PredictsFromTheTimesOfItsChecks)
{
    const std::string arguments = "plan " + problem(RoomFolder::planar()) + " --time-limit 100s --json";
    const nlohmann::json run = call(arguments + " --predict 1,2,16").json();
    EXPECT_EQ(run["status"], "solved");
    const nlohmann::json& predictions = run["predictions"];
    ASSERT_EQ(predictions.size(), 3U);
    EXPECT_EQ(predictions[0]["virtual_time_s"], run["wall_time_s"]);
    for (const nlohmann::json& row : predictions)
    {
        EXPECT_EQ(row["order_hash"], run["order_hash"]);
        EXPECT_EQ(row["checks_used"], run["checks_used"]);
        EXPECT_GT(row["speedup"], 0.0);
        EXPECT_LE(row["speedup"], row["threads"]);
    }
    EXPECT_GT(predictions[2]["speculative_used"], 0);
}

TEST_F(RigidBodyCommand, ReportsWhatTheFileSaysInVain)
{
    const Outcome outcome =
        call("plan " + problem(RoomFolder::planar() + "teleport =\n[colours]\nsky = blue\n") + " --planner RRTConnect");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 2) << outcome.err;
    EXPECT_NE(outcome.err.find("room.cfg:16: planner 'teleport' is not known and left out\n"), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("room.cfg:18: section [colours] is not known: sky is not heeded\n"), std::string::npos)
        << outcome.err;
}

TEST_F(RigidBodyCommand, RefusesBadProblemsInOneLine)
{
    struct Bad
    {
        std::string arguments;
        std::string complaint;
    };
    const std::string good = problem(RoomFolder::planar());
    const auto variant = [this](const std::string& name, const std::string& what, const std::string& by)
    { return "'" + room_.folder.write(name, replaced(RoomFolder::planar(), what, by)) + "'"; };
    const std::vector<Bad> bad{
        {"plan " + good + " --start 1,2", "--start: expected a map with this"},
        {"plan " + good + " --cost steps", "--cost: expected a map with this"},
        {"plan " + good + " --corner-cutting", "--corner-cutting: expected a map with this"},
        {"plan " + good + " --planner Teleport", "planner 'Teleport' is not known"},
        {"plan " + good + " --planner RRT:range", "planner RRT: expected key=value, found 'range'"},
        {"plan " + good + " --planner RRT:range=far", "planner RRT: range cannot be 'far'"},
        {"plan " + variant("a.cfg", "robot.obj", "none.obj"), "a.cfg:3: problem.robot: expected a mesh file"},
        {"plan " + variant("b.cfg", "start.x = 2", "start.x = 5"), "b.cfg:6: expected a free start"},
        {"plan " + variant("c.cfg", "name = room", "control = blimp"), "c.cfg:2: problem.control: problems with contr"},
        {"benchmark " + good + " --planners RRT,RRT", "--planners: expected 'RRT' once"},
        {"benchmark " + good + " --planners ,", "--planners: expected at least one planner"},
        {"benchmark " + good + " --runs 0", "--runs"},
        {"benchmark " + good + " --time-limit 0s", "--time-limit: expected more than 0s"},
        {"benchmark " + good + " --log " + file("none/a.log"), "a.log: cannot be written"},
        {"benchmark " + variant("d.cfg", "rrtconnect =", "rrtconnect.colour = red"),
         "d.cfg:15: planner rrtconnect: expected one of its parameters, found 'colour'"},
        {"benchmark " + variant("e.cfg", "rrtconnect =", ""), "e.cfg: expected planners"}};
    for (const Bad& each : bad)
    {
        const Outcome outcome = call(each.arguments);
        EXPECT_EQ(outcome.status, 2) << each.arguments;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        EXPECT_EQ(outcome.err.rfind("specplan: ", 0), 0U) << outcome.err;
        EXPECT_NE(outcome.err.find(each.complaint), std::string::npos) << outcome.err;
    }
}

TEST_F(RigidBodyCommand, BenchmarkRunsThePlannersOfTheFile)
{
    const Outcome outcome = call("benchmark " + problem(RoomFolder::planar()) + " --time-limit 20s --json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const nlohmann::json json = outcome.json();
    EXPECT_EQ(json["experiment"], "room");
    EXPECT_EQ(json["complete"], true);
    ASSERT_EQ(json["results"].size(), 2U) << "run_count of the file";
    for (const nlohmann::json& run : json["results"])
    {
        EXPECT_EQ(run["planner"], "geometric_RRTConnect");
        EXPECT_EQ(run["solved"], true);
        EXPECT_EQ(run["status"], "Exact solution");
        EXPECT_GT(run["state_checks"], 10);
    }
}

/// Our planner's own columns, on a map.
TEST_F(RigidBodyCommand, BenchmarkTellsOfSpeculation)
{
    const Outcome outcome = call("benchmark '" + scene("city-64.map") +
                                 "' --runs 2 --time-limit 60s --check-latency 20us --json --planners "
                                 "'SpeculativeAStar:num_threads=1;weight=1,SpeculativeAStar:num_threads=4;weight=1.0'");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json results = outcome.json()["results"];
    ASSERT_EQ(results.size(), 4U);
    EXPECT_EQ(results[2]["planner"], "geometric_SpeculativeAStar:num_threads=4 weight=1.0");
    for (const nlohmann::json& run : results)
    {
        EXPECT_EQ(run["expansions"], results[0]["expansions"]) << "whatever the number of threads";
        EXPECT_EQ(run["checks_used"], results[0]["checks_used"]);
        EXPECT_EQ(run["solution_length"], results[0]["solution_length"]);
        EXPECT_GE(run["accuracy"], 0.0);
        EXPECT_LE(run["coverage"], 1.0);
        EXPECT_TRUE(run.contains("wait_time"));
    }
    EXPECT_EQ(results[0]["speculative_checks"], 0);
    EXPECT_GT(results[2]["speculative_checks"], 0);
    EXPECT_GE(results[2]["state_checks"], results[2]["checks_used"]);
}

TEST_F(RigidBodyCommand, OmplsToolReadsTheLog)
{
    if (std::system("command -v ompl_benchmark_statistics >/dev/null") != 0)
        GTEST_SKIP() << "ompl_benchmark_statistics (package ompl-demos) is not installed";
    ASSERT_EQ(call("benchmark " + problem(RoomFolder::spatial()) +
                   " --planners 'RRTConnect,KPIECE1:range=2' --runs 3 --time-limit 20s --log " + file("a.log"))
                  .status,
              0);
    const std::string line =
        "ompl_benchmark_statistics " + file("a.log") + " -d " + file("a.db") + " >" + file("said") + " 2>&1";
    ASSERT_EQ(std::system(line.c_str()), 0) << room_.folder.read("said");
    const std::string query =
        "python3 -c \"import sqlite3, sys; print(sqlite3.connect(sys.argv[1]).execute('select count(*), "
        "min(state_checks) > 0 from runs').fetchone())\" " +
        file("a.db") + " >" + file("count");
    ASSERT_EQ(std::system(query.c_str()), 0);
    EXPECT_EQ(room_.folder.read("count"), "(6, 1)\n");
}

TEST_F(RigidBodyCommand, AnInterruptKeepsTheRunsCompleted)
{
    // The first planner is done within milliseconds, the second would go on for minutes. How long the first takes on
    // this machine nobody knows, so the interrupt comes later and later.
    const std::vector<std::string> arguments{"benchmark",
                                             room_.folder.write("room.cfg", RoomFolder::planar()),
                                             "--planners",
                                             "RRTConnect,RRTstar",
                                             "--runs",
                                             "1",
                                             "--time-limit",
                                             "600s",
                                             "--json",
                                             "--log",
                                             room_.folder / "a.log"};
    std::size_t kept = 0;
    for (int seconds = 1; kept == 0 && seconds < 60; seconds *= 2)
    {
        ASSERT_EQ(callAndInterrupt(arguments, room_.folder / "out", {std::chrono::seconds(seconds)}), 130);
        const nlohmann::json json = nlohmann::json::parse(room_.folder.read("out"));
        EXPECT_EQ(json["complete"], false);
        EXPECT_EQ(json["interrupted"], true);
        kept = json["results"].size();
    }
    EXPECT_EQ(kept, 1U);
    const std::string log = room_.folder.read("a.log");
    EXPECT_NE(log.find("\n1 planners\ngeometric_RRTConnect\n"), std::string::npos) << log;
    EXPECT_NE(log.find("\n1 runs\n"), std::string::npos);
}

TEST_F(RigidBodyCommand, AnInterruptKeepsAPathThatWasFound)
{
    // Finer lattices have better paths for a long time.
    const std::vector<std::string> arguments{"plan",         room_.folder.write("room.cfg", RoomFolder::planar()),
                                             "--anytime",    "--json",
                                             "--time-limit", "600s",
                                             "--path",       room_.folder / "path"};
    nlohmann::json json;
    int status = 1;
    for (int seconds = 1; status != 0 && seconds < 60; seconds *= 2)
    {
        status = callAndInterrupt(arguments, room_.folder / "out", {std::chrono::seconds(seconds)});
        ASSERT_TRUE(status == 0 || status == 130 || status == -SIGINT) << status;
        json = nlohmann::json::parse(room_.folder.read("out"), nullptr, false);
        EXPECT_EQ(status == 0, json.is_object() && json["status"] == "solved");
    }
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_GT(room_.folder.read("path").size(), 100U);
}
}  // namespace
}  // namespace specplan::test
