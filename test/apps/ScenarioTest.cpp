// SPDX-License-Identifier: BSD-3-Clause
// Published problems and their published figures. The files do not come with the project: the tests look for them in
// the folder that SPECPLAN_DATA_DIR names and are skipped where it is not set.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "Command.h"
#include "PlannedLength.h"
#include "specplan/problems/MovingAi.h"

namespace specplan::test
{
namespace
{
class Published : public testing::Test
{
protected:
    void SetUp() override
    {
        const char* folder = std::getenv("SPECPLAN_DATA_DIR");
        if (folder == nullptr || *folder == '\0')
            GTEST_SKIP() << "SPECPLAN_DATA_DIR is not set";
        folder_ = folder;
    }

    [[nodiscard]] std::string file(const std::string& name) const
    {
        return folder_ + "/" + name;
    }

private:
    std::string folder_;
};

/// How many of every n-th entries have the scenario's length within its rounding.
struct Agreement
{
    int entries = 0;
    int equal = 0;
};

/// \param rounding half a unit of the last place of a scenario's length.
Agreement compare(const std::string& map, std::size_t every, const std::function<double(double length)>& rounding)
{
    const problems::GridMap grid = problems::readMovingAiMap(map);
    const auto entries = problems::readMovingAiScenario(map + ".scen");
    Agreement agreement;
    for (std::size_t i = 0; i < entries.size(); i += every)
    {
        const double difference = plannedLength(grid, entries[i]) - entries[i].optimalLength;
        const bool equal = std::abs(difference) <= rounding(entries[i].optimalLength) + 1e-9;
        ++agreement.entries;
        agreement.equal += equal ? 1 : 0;
        if (!equal)
            std::cout << map << " #" << i << ": scenario " << entries[i].optimalLength << ", found longer by "
                      << difference << '\n';
    }
    return agreement;
}

TEST_F(Published, SeedMapsHaveTheCountsOfThePublishedLog)
{
    const nlohmann::json map3 = call("plan " + file("seed/map3.txt") + " --cost seed --threads 1 --json").json();
    EXPECT_EQ(map3["checks_used"], 6709);
    EXPECT_EQ(map3["expansions"], 5805);
    const nlohmann::json map4 = call("plan " + file("seed/map4.txt") + " --cost seed --threads 1 --json").json();
    EXPECT_EQ(map4["checks_used"], 3971);
    EXPECT_EQ(map4["expansions"], 2753);
}

TEST_F(Published, ThePapersSchemeHasThePapersSpeedUp)
{
    for (const char* map : {"seed/map3.txt", "seed/map4.txt"})
    {
        const std::string how =
            "plan " + file(map) + " --cost seed --executor virtual --threads 32 --barrier --json --policy ";
        const double direction = call(how + "direction --lookahead 4").json()["speedup"];
        EXPECT_GE(direction, 12.0) << map;
        EXPECT_LE(direction, 14.0) << map;
        const double none = call(how + "none").json()["speedup"];
        EXPECT_GE(none, 1.1) << map;
        EXPECT_LE(none, 1.5) << map;
        EXPECT_GT(call(how + "runahead").json()["speedup"], direction) << map;
    }
}

TEST_F(Published, ScenarioLengthsAreFound)
{
    // Six digits, of sums in single precision.
    const auto rounding = [](double length)
    { return 0.51 * std::pow(10.0, std::floor(std::log10(std::max(length, 1.0))) - 5.0); };
    const Agreement agreement = compare(file("movingai/hrt201n.map"), 3, rounding);
    EXPECT_GE(agreement.entries, 300);
    EXPECT_EQ(agreement.equal, agreement.entries);
}

TEST_F(Published, OldScenarioLengthsAreFound)
{
    // Two decimals.
    const Agreement agreement = compare(file("movingai/AR0011SR.map"), 4, [](double) { return 0.005; });
    EXPECT_GE(agreement.entries, 300);
    EXPECT_EQ(agreement.equal, agreement.entries);
}
}  // namespace
}  // namespace specplan::test
