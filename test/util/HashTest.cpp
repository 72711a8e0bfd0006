// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/Hash.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace specplan::util
{
namespace
{
TEST(Hash, IsTheSameOnEveryPlatform)
{
    // Order hashes are printed and compared between machines: these values must never change.
    EXPECT_EQ(hashCoordinates(std::array<std::int32_t, 2>{3, -4}), 0x95e15cbf8aa4ed87ULL);
    EXPECT_EQ(hashCoordinates(std::array<std::int32_t, 3>{0, 0, 1}), 0x5b9a7ec3602cea9bULL);
    EXPECT_EQ(mix(1, 2), 0xf9122d6051144cc9ULL);
}

TEST(Hash, TellsNearbyCoordinatesApart)
{
    std::set<std::uint64_t> hashes;
    for (std::int32_t x = -50; x < 50; ++x)
        for (std::int32_t y = -50; y < 50; ++y)
            hashes.insert(hashCoordinates(std::array<std::int32_t, 2>{x, y}) & 0xffffffffU);
    EXPECT_GT(hashes.size(), 9990U) << "nearly no two of 10000 share the lower half";
    EXPECT_NE(hashCoordinates(std::array<std::int32_t, 1>{0}), hashCoordinates(std::array<std::int32_t, 2>{0, 0}));
}
}  // namespace
}  // namespace specplan::util
