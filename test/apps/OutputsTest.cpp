// SPDX-License-Identifier: BSD-3-Clause
// Where the command reads from and writes to: files, links, pipes, devices, standard input and output.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <algorithm>
#include <filesystem>

#include "Command.h"

namespace specplan::test
{
namespace
{
namespace fs = std::filesystem;

std::size_t linesOf(const std::string& text)
{
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

class Outputs : public testing::Test
{
protected:
    [[nodiscard]] std::string file(const std::string& name) const
    {
        return "'" + folder_ / name + "'";
    }

    /// The path that the command writes to a file.
    [[nodiscard]] std::string path() const
    {
        EXPECT_EQ(call("plan " + kCity + " --path " + file("the path")).status, 0);
        std::string text = folder_.read("the path");
        fs::remove(folder_ / "the path");
        EXPECT_GT(linesOf(text), 10U);
        return text;
    }

    TemporaryFolder folder_;
};

TEST_F(Outputs, DevicesStayDevices)
{
    const std::string null = folder_ / "null";
    const bool made = mknod(null.c_str(), S_IFCHR | 0666, makedev(1, 3)) == 0;  // for root alone
    if (!made)
        fs::create_symlink("/dev/null", null);
    for (const char* option : {"--path", "--svg", "--trace"})
        EXPECT_EQ(call("plan " + kCity + ' ' + option + ' ' + file("null")).status, 0) << option;
    EXPECT_EQ(call("speedup " + kCity + " --executor virtual --threads 1,2 --csv " + file("null")).status, 0);
    EXPECT_EQ(call("speedup " + kCity + " --executor virtual --threads 1,2 --plot " + file("null")).status, 0);
    EXPECT_TRUE(fs::is_character_file(fs::symlink_status(made ? null : "/dev/null")));
    EXPECT_EQ(folder_.files(), 1);
    EXPECT_EQ(call("plan " + kCity + " --path /dev/null --svg /dev/null --json >/dev/null").status, 0)
        << "what is thrown away may be thrown away together";
}

TEST_F(Outputs, PipesAreFilled)
{
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    const Outcome outcome = shell("cat " + file("pipe") + " >" + file("got") + " & \"$SPECPLAN\" plan " + kCity +
                                  " --path " + file("pipe") + " && wait");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
    EXPECT_EQ(folder_.read("got"), path());
}

TEST_F(Outputs, LinksAndModesStay)
{
    fs::permissions(folder_.write("real", "old"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real", folder_ / "link");
    ASSERT_EQ(call("plan " + kCity + " --path " + file("link")).status, 0);
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(fs::status(folder_ / "real").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(folder_.read("real"), path());
}

TEST_F(Outputs, ADashIsStandardOutput)
{
    const std::string expected = path();
    for (const char* name : {"-", "/dev/stdout"})
    {
        const Outcome outcome = call("plan " + kCity + " --path " + name);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.out, expected);
        EXPECT_NE(outcome.err.find("status              solved"), std::string::npos) << "the table goes there";
    }
    const Outcome csv = call("speedup " + kCity + " --executor virtual --threads 1,2 --csv -");
    EXPECT_EQ(csv.out.rfind("problem,status,cost,", 0), 0U);
    EXPECT_EQ(linesOf(csv.out), 7U);
    const Outcome plot = call("speedup " + kCity + " --executor virtual --threads 1,2 --plot -");
    EXPECT_EQ(plot.out.rfind("<?xml", 0), 0U);
    const Outcome log = call("benchmark " + kCity + " --planners SpeculativeAStar --runs 1 --time-limit 20s --log -");
    EXPECT_EQ(log.out.rfind("OMPL version", 0), 0U) << log.out;
}

TEST_F(Outputs, ADashIsStandardInput)
{
    const std::string hash = call("plan " + kCity + " --json").json()["order_hash"];
    const std::string scen = " --scen " + kCity + ".scen --json ";
    EXPECT_EQ(call("plan -" + scen + "<" + kCity).json()["order_hash"], hash);
    EXPECT_EQ(shell("cat " + kCity + " | \"$SPECPLAN\" plan -" + scen).json()["order_hash"], hash);
    EXPECT_EQ(call("plan " + kCity + " --json --scen - <" + kCity + ".scen").json()["order_hash"], hash);
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(shell("cat " + kCity + " >" + file("pipe") + " & \"$SPECPLAN\" plan " + file("pipe") + scen)
                  .json()["order_hash"],
              hash)
        << "a pipe with a name of its own";
    const std::string seed = folder_.write("seed.txt", "N\n2,2\nC\n1\nR\n1,1\nT\n2,2\nM\n0,0\n0,0\n");
    EXPECT_EQ(call("plan - --json <" + seed).json()["status"], "solved");
    const Outcome bad = call("plan - --start 0,0 --goal 1,1 </dev/null");
    EXPECT_EQ(bad.err, "specplan: standard input:1: expected 'type octile', found the end of the file\n");
}

TEST_F(Outputs, ALostOutputIsAnError)
{
    if (!fs::is_character_file("/dev/full"))
        GTEST_SKIP() << "this system has no /dev/full";
    const std::vector<std::string> calls{
        "plan " + kCity,
        "plan " + kCity + " --json",
        "plan " + kCity + " --explain",
        "plan " + kCity + " --path -",
        "speedup " + kCity + " --executor virtual --threads 1,2",
        "speedup " + kCity + " --executor virtual --threads 1,2 --json",
        "benchmark " + kCity + " --planners RRTConnect --runs 1 --time-limit 5s",
        "benchmark " + kCity + " --planners RRTConnect --runs 1 --time-limit 5s --json",
        "--help",
        "plan --help",
        "--version",
        "--man",
        "--completion bash"};
    for (const std::string& each : calls)
    {
        const Outcome full = call(each + " >/dev/full");
        EXPECT_EQ(full.status, 2) << each;
        EXPECT_NE(full.err.find("specplan: standard output: cannot be written"), std::string::npos)
            << each << ": " << full.err;
        const Outcome closed = call(each + " >&-");
        EXPECT_EQ(closed.status, 2) << each;
        EXPECT_NE(closed.err.find("specplan: standard output: cannot be written"), std::string::npos)
            << each << ": " << closed.err;
    }
    const Outcome path = call("plan " + kCity + " --path /dev/full");
    EXPECT_EQ(path.status, 2);
    EXPECT_EQ(path.err, "specplan: /dev/full: cannot be written: No space left on device\n");
}

/// A file that is opened where standard output was closed must not get what was meant for that.
TEST_F(Outputs, ClosedOutputIsNotWrittenToAFile)
{
    EXPECT_EQ(call("plan " + kCity + " --path " + file("a") + " >&-").status, 2);
    EXPECT_EQ(folder_.read("a"), path());
}

TEST_F(Outputs, FilesThatWouldBeLostAreRefused)
{
    fs::copy(kCity, folder_ / "city-64.map");
    fs::copy(kCity + ".scen", folder_ / "city-64.map.scen");
    fs::create_symlink("city-64.map", folder_ / "link");
    fs::create_hard_link(folder_ / "city-64.map", folder_ / "twin");
    const std::string map = file("city-64.map");
    const std::string speedup = "speedup " + map + " --executor virtual --threads 1,2 ";
    struct Bad
    {
        std::string arguments;
        std::string complaint;
    };
    const std::vector<Bad> bad{
        {"plan " + map + " --svg " + map, "--svg: " + folder_ / "city-64.map" + " is an input; expected another file"},
        {"plan " + map + " --path " + file("link"), "--path: " + folder_ / "link" + " is an input"},
        {"plan " + map + " --path " + file("twin"), "--path: " + folder_ / "twin" + " is an input"},
        {"plan " + map + " --path " + file("city-64.map.scen"),
         "--path: " + folder_ / "city-64.map.scen" + " is an input"},
        {"plan - --scen " + file("city-64.map.scen") + " --path " + map + " <" + map, "city-64.map is an input"},
        {speedup + "--csv " + map, "--csv: " + folder_ / "city-64.map" + " is an input"},
        {"benchmark " + map + " --planners RRT --log " + map, "--log: " + folder_ / "city-64.map" + " is an input"},
        {"plan " + map + " --svg x --path x", "--svg and --path: expected two files, found x for both"},
        {"plan " + map + " --svg x --path ./x", "--svg and --path: expected two files"},
        {"plan " + map + " --svg - --path -", "--svg and --path: expected two files"},
        {"plan " + map + " --svg - --path /dev/stdout", "--svg and --path: expected two files"},
        {speedup + "--csv x --plot x", "--csv and --plot: expected two files"},
        {"plan " + map + " --path - --json", "--path -: expected a file; --json takes standard output"},
        {speedup + "--csv - --json", "--csv -: expected a file; --json takes standard output"},
        {"benchmark " + map + " --planners RRT --log - --json", "--log -: expected a file; --json"},
        {"plan - --scen - <" + map, "standard input: expected once"},
        {"speedup - - <" + map, "standard input: expected once"}};
    for (const Bad& each : bad)
    {
        const Outcome outcome = shell("cd " + file("") + " && \"$SPECPLAN\" " + each.arguments);
        EXPECT_EQ(outcome.status, 2) << each.arguments;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(linesOf(outcome.err), 1U) << outcome.err;
        EXPECT_NE(outcome.err.find(each.complaint), std::string::npos) << outcome.err;
    }
    const Outcome same = call("plan " + map + " --path " + file("out") + " >" + file("out"));
    EXPECT_EQ(same.status, 2);
    EXPECT_NE(same.err.find("out is where standard output goes; expected another file, or -"), std::string::npos);
    EXPECT_EQ(folder_.files(), 5) << "map, scenario, link, twin, and the shell's out";
    EXPECT_EQ(fs::file_size(folder_ / "city-64.map"), fs::file_size(kCity));
}

TEST_F(Outputs, EmptyValuesAreRefused)
{
    const std::vector<std::string> options{"--svg",        "--html",          "--trace",      "--path",     "--planner",
                                           "--time-limit", "--check-latency", "--check-busy", "--threads",  "--weight",
                                           "--index",      "--policy",        "--scen",       "--start",    "--predict",
                                           "--cost",       "--evaluation",    "--executor",   "--lookahead"};
    for (const std::string& option : options)
        for (const std::string& empty : {option + " \"\"", option + "="})
        {
            const Outcome outcome = call("plan " + kCity + ' ' + empty);
            EXPECT_EQ(outcome.status, 2) << empty;
            EXPECT_EQ(linesOf(outcome.err), 1U) << outcome.err;
            EXPECT_NE(outcome.err.find(option), std::string::npos) << outcome.err;
        }
    EXPECT_EQ(call("plan \"\"").err, "specplan: PROBLEM: expected a file, found an empty value\n");
    for (const char* option : {"--csv", "--plot", "--policies"})
        EXPECT_EQ(call("speedup " + kCity + ' ' + option + " \"\"").status, 2) << option;
    for (const char* option : {"--log", "--planners", "--runs", "--memory-limit"})
        EXPECT_EQ(call("benchmark " + kCity + ' ' + option + " \"\"").status, 2) << option;
}

TEST_F(Outputs, APlotWithoutGnuplotIsRefusedBeforeTheWork)
{
    const Outcome outcome = shell("PATH=/nowhere \"$SPECPLAN\" speedup " + kCity +
                                  " --executor virtual --threads 1,2 --plot " + file("a.svg"));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "specplan: --plot: gnuplot is needed to draw the plot and was not found\n");
}

TEST_F(Outputs, AScenarioOfAnotherMapIsNoted)
{
    fs::copy(kCity, folder_ / "other.map");
    const std::string line = "is for the map city-64.map, not for ";
    const Outcome other = call("plan " + file("other.map") + " --scen " + kCity + ".scen --json");
    EXPECT_EQ(other.status, 0);
    EXPECT_NE(other.err.find("specplan: warning: " + kCity + ".scen: entry 9 " + line), std::string::npos) << other.err;
    EXPECT_EQ(other.json()["status"], "solved");
    EXPECT_EQ(call("plan " + kCity + " --scen " + kCity + ".scen").err, "");
}

TEST_F(Outputs, ControlCharactersOfFilesDoNotReachTheTerminal)
{
    const auto isPlain = [](const std::string& text)
    { return std::ranges::none_of(text, [](unsigned char c) { return (c < 32 && c != '\n') || c >= 127; }); };
    const std::string map = "type octile\nheight 2\nwidth 2\nmap\n..\n..\n";
    for (std::size_t at = 0; at < map.size(); ++at)
        for (const char byte : {'\x02', '\x1b', '\x7f', '\x9b', '\t'})
        {
            std::string damaged = map;
            damaged[at] = byte;
            const Outcome outcome =
                call("plan '" + folder_.write("m.map", damaged) + "' --start 0,0 --goal 1,1 --executor virtual");
            EXPECT_TRUE(isPlain(outcome.err)) << at << ": " << outcome.err;
            if (at % 5 != 0)
                break;
        }
    const Outcome cfg = call("plan '" + folder_.write("a.cfg", "[problem]\nrobot = \x1b[2J\nworld = x\n") + "'");
    EXPECT_EQ(cfg.status, 2);
    EXPECT_TRUE(isPlain(cfg.err)) << cfg.err;
    EXPECT_EQ(linesOf(cfg.err), 1U);
}
}  // namespace
}  // namespace specplan::test
