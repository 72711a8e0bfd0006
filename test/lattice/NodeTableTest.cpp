// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/NodeTable.h"

#include <gtest/gtest.h>

#include <array>

namespace specplan::lattice
{
namespace
{
TEST(NodeTable, NumbersInOrderOfFirstTouch)
{
    NodeTable table(2);
    const std::array<Coordinate, 2> a{5, -7};
    const std::array<Coordinate, 2> b{-7, 5};
    EXPECT_EQ(table.find(a.data()), kNoNode);
    EXPECT_EQ(table.intern(a.data()), 0U);
    EXPECT_EQ(table.intern(b.data()), 1U);
    EXPECT_EQ(table.intern(a.data()), 0U);
    EXPECT_EQ(table.find(b.data()), 1U);
    EXPECT_EQ(table.size(), 2U);
    EXPECT_EQ(table.coordinates(0)[1], -7);
}

TEST(NodeTable, KeepsEveryNodeWhileItGrows)
{
    NodeTable table(3);
    const auto at = [](Coordinate i) { return std::array<Coordinate, 3>{i % 40 - 20, i / 40 % 40 - 20, i / 1600}; };
    constexpr Coordinate kNodes = 64000;
    for (Coordinate i = 0; i < kNodes; ++i)
        ASSERT_EQ(table.intern(at(i).data()), static_cast<NodeId>(i));
    for (Coordinate i = 0; i < kNodes; ++i)
    {
        ASSERT_EQ(table.find(at(i).data()), static_cast<NodeId>(i));
        const auto row = table.coordinates(static_cast<NodeId>(i));
        ASSERT_TRUE(std::equal(row.begin(), row.end(), at(i).begin()));
    }
}
}  // namespace
}  // namespace specplan::lattice
