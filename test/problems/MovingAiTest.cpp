// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/MovingAi.h"

#include <gtest/gtest.h>

#include "TemporaryFolder.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace
{
using test::complaintOf;
using test::TemporaryFolder;

TEST(MovingAiMap, ReadsFreeAndBlockedCells)
{
    const TemporaryFolder folder;
    const GridMap map =
        readMovingAiMap(folder.write("a.map", "type octile\nheight 2\nwidth 7\nmap\n.GS@OTW\n@@@@@@.\n"));
    ASSERT_EQ(map.width(), 7);
    ASSERT_EQ(map.height(), 2);
    for (int x = 0; x < 7; ++x)
    {
        EXPECT_EQ(map.isFree(x, 0), x < 3) << x;
        EXPECT_EQ(map.isFree(x, 1), x == 6) << x;
    }
    EXPECT_FALSE(map.isFree(-1, 0));
    EXPECT_FALSE(map.isFree(0, 2));
}

TEST(MovingAiMap, ReadsLineEndsOfAnyKind)
{
    const TemporaryFolder folder;
    const GridMap map =
        readMovingAiMap(folder.write("a.map", "type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.@\r\n\r\n"));
    EXPECT_TRUE(map.isFree(0, 0));
    EXPECT_FALSE(map.isFree(1, 0));
    EXPECT_EQ(readMovingAiMap(folder.write("b.map", "type octile\nheight 1\nwidth 2\nmap\n.@")).width(), 2);
}

TEST(MovingAiMap, ComesBackAsWritten)
{
    const TemporaryFolder folder;
    GridMap map(3, 2);
    map.setFree(1, 0, true);
    map.setFree(2, 1, true);
    writeMovingAiMap(folder / "a.map", map);
    const GridMap again = readMovingAiMap(folder / "a.map");
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            EXPECT_EQ(again.isFree(x, y), map.isFree(x, y));
    EXPECT_EQ(folder.files(), 1);
}

struct BadText
{
    const char* text;
    const char* complaint;  ///< after the name of the file
};

class BadMovingAiMap : public testing::TestWithParam<BadText>
{
};

TEST_P(BadMovingAiMap, SaysWhatWasExpectedWhere)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("bad.map", GetParam().text);
    EXPECT_EQ(complaintOf<InputError>([&] { (void)readMovingAiMap(file); }), file + GetParam().complaint);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadMovingAiMap,
    testing::Values(
        BadText{"", ":1: expected 'type octile', found the end of the file"},
        BadText{"type tile\n", ":1: expected 'type octile', found 'type tile'"},
        BadText{"type octile\nwidth 3\n", ":2: expected 'height N' with N from 1, found 'width 3'"},
        BadText{"type octile\nheight 0\n", ":2: expected 'height N' with N from 1, found 'height 0'"},
        BadText{"type octile\nheight 3x\n", ":2: expected 'height N' with N from 1, found 'height 3x'"},
        BadText{"type octile\nheight 99999999999\n",
                ":2: expected 'height N' with N from 1, found 'height 99999999999'"},
        BadText{"type octile\nheight 1\n", ":3: expected 'width N' with N from 1, found the end of the file"},
        BadText{"type octile\nheight 1000000\nwidth 1000000\nmap\n",
                ":3: expected at most 2^28 cells, found 1000000 x 1000000"},
        BadText{"type octile\nheight 1\nwidth 1\nmaps\n", ":4: expected 'map', found 'maps'"},
        BadText{"type octile\nheight 2\nwidth 2\nmap\n..\n", ":6: expected row 2 of 2, found the end of the file"},
        BadText{"type octile\nheight 2\nwidth 2\nmap\n..\n...\n", ":6: expected a row of 2 cells, found 3"},
        BadText{"type octile\nheight 1\nwidth 2\nmap\n.x\n",
                ":5: expected one of . G S @ O T W, found 'x' in column 2"},
        BadText{"type octile\nheight 1\nwidth 2\nmap\n..\n..\n", ":6: expected the end of the file after 1 rows"}));

TEST(MovingAiMap, NamesAFileThatIsNotThere)
{
    const TemporaryFolder folder;
    const std::string file = folder / "none.map";
    EXPECT_EQ(complaintOf<InputError>([&] { (void)readMovingAiMap(file); }),
              file + ": cannot be read: no such file, or no permission");
    EXPECT_EQ(complaintOf<InputError>([&] { (void)readMovingAiMap(folder / "."); }),
              folder / "." + std::string(": expected a file, found a directory"));
}

TEST(MovingAiScenario, ReadsTabsAndBlanksAndBothVersions)
{
    const TemporaryFolder folder;
    const auto tabs = readMovingAiScenario(folder.write("a.scen", "version 1\n3\ta.map\t4\t5\t0\t1\t2\t3\t6.5\n\n"));
    ASSERT_EQ(tabs.size(), 1U);
    EXPECT_EQ(tabs[0].bucket, 3);
    EXPECT_EQ(tabs[0].map, "a.map");
    EXPECT_EQ(tabs[0].width, 4);
    EXPECT_EQ(tabs[0].height, 5);
    EXPECT_EQ(tabs[0].start, (GridCell{0, 1}));
    EXPECT_EQ(tabs[0].goal, (GridCell{2, 3}));
    EXPECT_EQ(tabs[0].optimalLength, 6.5);
    EXPECT_EQ(readMovingAiScenario(folder.write("b.scen", "version 1.0\n3 a.map 4 5 0 1 2 3 6.5\r\n")).size(), 1U);
}

TEST(MovingAiScenario, ComesBackAsWritten)
{
    const TemporaryFolder folder;
    writeMovingAiScenario(folder / "a.scen", {{1, "m.map", 9, 8, {7, 6}, {5, 4}, 2.41421356}});
    const auto again = readMovingAiScenario(folder / "a.scen");
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again[0].goal, (GridCell{5, 4}));
    EXPECT_EQ(again[0].optimalLength, 2.41421356);
}

TEST(MovingAiScenario, SaysWhatWasExpectedWhere)
{
    const TemporaryFolder folder;
    const std::string version = folder.write("a.scen", "1 a.map 1 1 0 0 0 0 0\n");
    EXPECT_EQ(complaintOf<InputError>([&] { (void)readMovingAiScenario(version); }),
              version + ":1: expected 'version 1', found '1 a.map 1 1 0 0 0 0 0'");
    const std::string line = folder.write("b.scen", "version 1\n1 a.map 1 1 0 0 0 zero 0\n");
    EXPECT_EQ(complaintOf<InputError>([&] { (void)readMovingAiScenario(line); }),
              line +
                  ":2: expected 'bucket map width height start-x start-y goal-x goal-y length', found "
                  "'1 a.map 1 1 0 0 0 zero 0'");
}
}  // namespace
}  // namespace specplan::problems
