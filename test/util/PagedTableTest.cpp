// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/PagedTable.h"

#include <gtest/gtest.h>

namespace specplan::util
{
namespace
{
TEST(PagedTable, KnowsOnlyWhatWasTouched)
{
    PagedTable<int> table;
    EXPECT_EQ(table.find(0), nullptr);
    table[5000000] = 3;
    EXPECT_EQ(table.find(0), nullptr);
    EXPECT_EQ(table.find(50000000), nullptr);
    ASSERT_NE(table.find(5000000), nullptr);
    EXPECT_EQ(*table.find(5000000), 3);
    table[0] = 1;
    EXPECT_EQ(*table.find(0), 1);
    EXPECT_EQ(table[1], 0) << "new entries are zero";
}

TEST(PagedTable, KeepsValuesAndAddressesWhileItGrows)
{
    PagedTable<std::size_t> table;
    std::vector<std::size_t*> addresses;
    for (std::size_t i = 0; i < 20000; ++i)
    {
        table[i * 3] = i;
        addresses.push_back(&table[i * 3]);
    }
    for (std::size_t i = 0; i < 20000; ++i)
    {
        ASSERT_EQ(&table[i * 3], addresses[i]);
        ASSERT_EQ(table[i * 3], i);
        ASSERT_EQ(table[i * 3 + 1], 0U);
    }
}
}  // namespace
}  // namespace specplan::util
