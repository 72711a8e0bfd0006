// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/RowPool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

namespace specplan::util
{
namespace
{
TEST(RowPool, RowsKeepTheirItemsHoweverTheyGrow)
{
    std::mt19937 random(7);
    RowPool<int> pool;
    std::vector<RowPool<int>::Row> rows(300);
    std::vector<std::vector<int>> expected(rows.size());
    EXPECT_TRUE(pool.items(rows[0]).empty());
    for (int item = 0; item < 200000; ++item)
    {
        const std::size_t most = std::uniform_int_distribution<std::size_t>(1, rows.size())(random);
        const std::size_t row = std::uniform_int_distribution<std::size_t>(0, most - 1)(random);  // of many lengths
        pool.append(rows[row], item);
        expected[row].push_back(item);
    }
    for (std::size_t row = 0; row < rows.size(); ++row)
        EXPECT_TRUE(std::ranges::equal(pool.items(rows[row]), expected[row])) << row;
}

TEST(RowPool, PlacesThatRowsHaveLeftAreUsedAgain)
{
    RowPool<int> pool;
    RowPool<int>::Row first;
    for (int item = 0; item < 4; ++item)
        pool.append(first, item);
    const int* place = pool.items(first).data();
    pool.append(first, 4);
    EXPECT_NE(pool.items(first).data(), place);
    RowPool<int>::Row second;
    pool.append(second, 5);
    EXPECT_EQ(pool.items(second).data(), place);
}

TEST(RowPool, ARowThatIsTooLongIsRefusedAndStaysWhatItWas)
{
    RowPool<int> pool;
    RowPool<int>::Row row;
    for (int item = 0; item < 65535; ++item)
        pool.append(row, item);
    EXPECT_THROW(pool.append(row, 0), std::length_error);
    ASSERT_EQ(pool.items(row).size(), 65535U);
    EXPECT_EQ(pool.items(row)[65534], 65534);
}
}  // namespace
}  // namespace specplan::util
