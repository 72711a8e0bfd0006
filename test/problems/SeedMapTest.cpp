// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/SeedMap.h"

#include <gtest/gtest.h>

#include "TemporaryFolder.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace
{
using test::complaintOf;
using test::TemporaryFolder;

const std::string kGood = "N\n2,3\nC\n5\nR\n1,1\nT\n2,3\nM\n1,5,4\n9,1,1\n";

/// kGood with its n-th line replaced, counted from 1.
std::string withLine(int n, const std::string& replacement)
{
    std::istringstream in(kGood);
    std::string out;
    int number = 0;
    for (std::string line; std::getline(in, line);)
        out += (++number == n ? replacement : line) + '\n';
    return out;
}

TEST(SeedMap, FirstNumberIsX)
{
    const TemporaryFolder folder;
    const GridProblem problem = readSeedMap(folder.write("m.txt", kGood));
    EXPECT_EQ(problem.map.width(), 2);
    EXPECT_EQ(problem.map.height(), 3);
    EXPECT_EQ(problem.start, (GridCell{0, 0}));
    EXPECT_EQ(problem.goal, (GridCell{1, 2}));
    EXPECT_TRUE(problem.map.isFree(0, 0));
    EXPECT_FALSE(problem.map.isFree(0, 1)) << "the threshold itself is an obstacle";
    EXPECT_TRUE(problem.map.isFree(0, 2));
    EXPECT_FALSE(problem.map.isFree(1, 0));
    EXPECT_TRUE(problem.map.isFree(1, 1));
}

TEST(SeedMap, OfAMovingTargetTheFirstCellCounts)
{
    const TemporaryFolder folder;
    EXPECT_EQ(readSeedMap(folder.write("m.txt", withLine(8, "1,2\n2,2\n1,1"))).goal, (GridCell{0, 1}));
}

TEST(SeedMap, IsToldFromOtherFiles)
{
    const TemporaryFolder folder;
    EXPECT_TRUE(looksLikeSeedMap(kGood));
    EXPECT_FALSE(looksLikeSeedMap("type octile\n"));
    EXPECT_FALSE(looksLikeSeedMap(""));
}

struct BadLine
{
    int line;
    const char* text;
    const char* complaint;  ///< after the name of the file
};

class BadSeedMap : public testing::TestWithParam<BadLine>
{
};

TEST_P(BadSeedMap, SaysWhatWasExpectedWhere)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("bad.txt", withLine(GetParam().line, GetParam().text));
    EXPECT_EQ(complaintOf<InputError>([&] { (void)readSeedMap(file); }), file + GetParam().complaint);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadSeedMap,
    testing::Values(BadLine{1, "M", ":1: expected 'N', found 'M'"},
                    BadLine{2, "2;3", ":2: expected the size of the map as two whole numbers 'a,b', found '2;3'"},
                    BadLine{2, "0,3", ":2: expected a size of 1 to 2^28 cells"},
                    BadLine{2, "100000,100000", ":2: expected a size of 1 to 2^28 cells"},
                    BadLine{3, "X", ":3: expected 'C', found 'X'"},
                    BadLine{4, "five", ":4: expected the collision threshold, a number, found 'five'"},
                    BadLine{4, "nan", ":4: expected the collision threshold, a number, found 'nan'"},
                    BadLine{6, "3,1", ":6: expected the robot's cell inside the map, 1,1 to 2,3, found '3,1'"},
                    BadLine{8, "1,0", ":8: expected the target's cell inside the map, 1,1 to 2,3, found '1,0'"},
                    BadLine{9, "1,1", ":12: expected 'M', found the end of the file"},
                    BadLine{10, "1,5", ":10: expected 3 costs, found 2"},
                    BadLine{11, "9,a,1", ":11: expected a number, found 'a'"}));

TEST(SeedMap, NoticesATruncatedMap)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("bad.txt", kGood.substr(0, kGood.size() - 6));
    EXPECT_EQ(complaintOf<InputError>([&] { (void)readSeedMap(file); }),
              file + ":11: expected line 2 of 2 of M, found the end of the file");
}
}  // namespace
}  // namespace specplan::problems
