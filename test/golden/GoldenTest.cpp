// SPDX-License-Identifier: BSD-3-Clause
// Searches whose order, counts, costs and virtual times are written down. A change that is meant to change nothing
// changes none of them; one that is meant to writes them anew:
//   SPECPLAN_WRITE_GOLDEN=test/golden/runs.txt build/test/test/golden/test_golden
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "GoldenRuns.h"

namespace specplan::test
{
namespace
{
std::map<std::string, std::string> writtenDown()
{
    std::map<std::string, std::string> lines;
    std::ifstream in(SPECPLAN_GOLDEN_FILE);
    for (std::string line; std::getline(in, line);)
        lines.emplace(line.substr(0, line.find(' ')), line);
    return lines;
}

TEST(Golden, OrderCountsCostsAndVirtualTimesAreThoseWrittenDown)
{
    const std::map<std::string, std::string> expected = writtenDown();
    std::ofstream out;
    if (const char* file = std::getenv("SPECPLAN_WRITE_GOLDEN"))
        out.open(file);
    std::size_t runs = 0;
    for (const GoldenRun& run : goldenRuns(SPECPLAN_SCENES_DIR))
    {
        const std::string line = resultOf(run);
        ++runs;
        if (out.is_open())
        {
            out << line << '\n';
            continue;
        }
        const auto found = expected.find(run.name);
        ASSERT_NE(found, expected.end()) << "not written down: " << line;
        EXPECT_EQ(line, found->second);
    }
    EXPECT_GE(runs, 200U);
    if (out.is_open())
    {
        GTEST_SKIP() << "written down anew";
    }
}
}  // namespace
}  // namespace specplan::test
