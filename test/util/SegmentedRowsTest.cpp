// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/SegmentedRows.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace specplan::util
{
namespace
{
TEST(SegmentedRows, KeepsValuesAndAddressesWhileItGrows)
{
    SegmentedRows<int> rows(3);
    std::vector<int*> addresses;
    for (int i = 0; i < 10000; ++i)
    {
        int* row = rows.append();
        EXPECT_EQ(row[0] + row[1] + row[2], 0) << "new rows are zero";
        row[0] = i;
        row[2] = -i;
        addresses.push_back(row);
    }
    ASSERT_EQ(rows.size(), 10000U);
    for (std::size_t i = 0; i < 10000; ++i)
    {
        ASSERT_EQ(rows.row(i), addresses[i]);
        ASSERT_EQ(rows.row(i)[0], static_cast<int>(i));
        ASSERT_EQ(rows.row(i)[2], -static_cast<int>(i));
    }
}

TEST(SegmentedRows, GrowToNeverShrinks)
{
    SegmentedRows<int> rows;
    rows.growTo(5000);
    EXPECT_EQ(rows.size(), 5000U);
    rows[4999] = 7;
    rows.growTo(10);
    EXPECT_EQ(rows.size(), 5000U);
    EXPECT_EQ(rows[4999], 7);
}

TEST(SegmentedRows, OthersMayReadWhileTheOwnerAppends)
{
    SegmentedRows<std::size_t> rows;
    std::atomic<std::size_t> handedOver{0};
    std::thread reader(
        [&]
        {
            for (std::size_t read = 0; read < 50000;)
                for (const std::size_t until = handedOver.load(std::memory_order_acquire); read < until; ++read)
                    ASSERT_EQ(rows[read], read);
        });
    for (std::size_t i = 0; i < 50000; ++i)
    {
        *rows.append() = i;
        handedOver.store(i + 1, std::memory_order_release);
    }
    reader.join();
}
}  // namespace
}  // namespace specplan::util
