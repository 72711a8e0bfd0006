// SPDX-License-Identifier: BSD-3-Clause
// What Ctrl-C does.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "CallAndInterrupt.h"
#include "Command.h"

namespace specplan::test
{
namespace
{
using std::chrono::milliseconds;

/// Interrupts later and later until there is a result of the wanted kind: how long the start takes on a machine that
/// is busy nobody knows, and before it Ctrl-C ends the program as any other.
template <typename Call>
int repeated(const Call& call)
{
    int status = -SIGINT;
    for (milliseconds after{500}; status == -SIGINT && after < milliseconds(60000); after *= 2)
        status = call(after);
    return status;
}

TEST(Interrupt, IsAStatusOfItsOwn)
{
    const TemporaryFolder folder;
    const int status = repeated(
        [&](milliseconds after)
        {
            return callAndInterrupt(
                {"plan", kCity, "--threads", "1", "--check-latency", "1s", "--json", "--path", folder / "path"},
                folder / "out", {after});
        });
    EXPECT_EQ(status, 130);
    EXPECT_EQ(nlohmann::json::parse(folder.read("out"))["status"], "interrupted");
    EXPECT_EQ(folder.files(), 1) << "no path, no file";

    EXPECT_EQ(repeated(
                  [&](milliseconds after) {
                      return callAndInterrupt({"plan", kCity, "--check-latency", "1s"}, folder / "out", {after});
                  }),
              130);
    EXPECT_NE(folder.read("out").find("status              interrupted"), std::string::npos);
}

TEST(Interrupt, StoppedSpeedupsLeaveWhatIsFinishedOrNothing)
{
    const TemporaryFolder folder;
    const std::vector<std::string> slow{"speedup", kCity,   "--check-latency", "100ms", "--threads",
                                        "1,2",     "--csv", folder / "csv",    "--json"};
    EXPECT_EQ(repeated([&](milliseconds after) { return callAndInterrupt(slow, folder / "out", {after}); }), 130);
    const nlohmann::json nothing = nlohmann::json::parse(folder.read("out"));
    EXPECT_EQ(nothing["interrupted"], true);
    EXPECT_EQ(nothing["results"].size(), 0U);
    EXPECT_EQ(folder.files(), 1) << "no rows, no file";

    // The first two take no time, the third would take minutes.
    const std::string maze = scene("maze-256.map");
    std::size_t rows = 0;
    for (milliseconds after{1000}; rows == 0 && after < milliseconds(60000); after *= 2)
    {
        const int status = callAndInterrupt({"speedup", kCity, maze, "--check-latency", "150us", "--threads", "1,2",
                                             "--policies", "none", "--csv", folder / "csv", "--json"},
                                            folder / "out", {after});
        if (status == 0)
            break;  // too late
        ASSERT_TRUE(status == 130 || status == -SIGINT) << status;
        if (status == 130)
            rows = nlohmann::json::parse(folder.read("out"))["results"].size();
    }
    if (rows > 0)
    {
        const std::string csv = folder.read("csv");
        EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), rows + 1);
    }
}

TEST(Interrupt, TheSecondOneEndsTheProgram)
{
    // Nobody waits for a check of a day.
    const TemporaryFolder folder;
    const std::vector<std::string> endless{"plan", kCity, "--threads", "1", "--check-latency", "86400s"};
    EXPECT_EQ(callAndInterrupt(endless, folder / "out", {milliseconds(1500), milliseconds(1500)}), -SIGINT);
    EXPECT_EQ(folder.read("out"), "");
}

TEST(Interrupt, EndsAProgramThatIsReading)
{
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const char* subcommand : {"plan", "speedup", "benchmark"})
        EXPECT_EQ(callAndInterrupt({subcommand, pipe}, folder / "out", {milliseconds(300)}), -SIGINT)
            << "nobody writes to the pipe";
}
}  // namespace
}  // namespace specplan::test
