// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/GrowingArray.h"

#include <gtest/gtest.h>

namespace specplan::util
{
namespace
{
struct Item
{
    int value = -1;
};

TEST(GrowingArray, KeepsValuesWhileItGrowsAndInitialisesNewOnes)
{
    GrowingArray<Item> items;
    EXPECT_EQ(items.size(), 0U);
    for (std::size_t i = 0; i < 100000; ++i)
    {
        items.growTo(i + 1);
        ASSERT_EQ(items[i].value, -1);
        items[i].value = static_cast<int>(i);
    }
    items.growTo(250000);
    ASSERT_EQ(items.size(), 250000U);
    int expected = 0;
    for (const Item& item : items)
    {
        ASSERT_EQ(item.value, expected < 100000 ? expected : -1);
        ++expected;
    }
}

TEST(GrowingArray, NeverShrinks)
{
    GrowingArray<Item> items;
    items.growTo(10);
    items[9].value = 7;
    items.growTo(3);
    ASSERT_EQ(items.size(), 10U);
    EXPECT_EQ(items[9].value, 7);
}
}  // namespace
}  // namespace specplan::util
