// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/Processors.h"

#include <gtest/gtest.h>

#if defined(__linux__)
#include <sched.h>
#endif

#include <filesystem>
#include <fstream>
#include <thread>

namespace specplan::util
{
namespace
{
/// A tree of control groups of the test's own.
class ControlGroups : public testing::Test
{
protected:
    ControlGroups()
        : root_(std::filesystem::path(testing::TempDir()) /
                (std::string("cgroup_") + testing::UnitTest::GetInstance()->current_test_info()->name()))
    {
        std::filesystem::remove_all(root_);
        std::filesystem::create_directories(root_);
    }

    ~ControlGroups() override
    {
        std::filesystem::remove_all(root_);
    }

    void write(const std::string& path, const std::string& content) const
    {
        const std::filesystem::path file = root_ / path;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << content;
    }

    [[nodiscard]] std::optional<unsigned> processors(const std::string& selfCgroup) const
    {
        return processorsOfGroups(selfCgroup, root_.string());
    }

private:
    std::filesystem::path root_;
};

TEST(Processors, AQuotaStandsForSoManyRoundedUp)
{
    EXPECT_EQ(processorsOfQuota("200000 100000\n"), 2U);
    EXPECT_EQ(processorsOfQuota("150000 100000"), 2U);
    EXPECT_EQ(processorsOfQuota("10000 100000"), 1U);
    EXPECT_EQ(processorsOfQuota("max 100000\n"), std::nullopt);
    for (const char* odd : {"", "100000", "0 100000", "100000 0", "-1 100000", "x y"})
        EXPECT_EQ(processorsOfQuota(odd), std::nullopt) << odd;
    EXPECT_EQ(processorsOfQuota("400000\n", "100000\n"), 4U);
    EXPECT_EQ(processorsOfQuota("-1\n", "100000\n"), std::nullopt);
    EXPECT_EQ(processorsOfQuota("", ""), std::nullopt);
}

TEST_F(ControlGroups, OfVersionTwoTheLeastQuotaOnTheWayCounts)
{
    EXPECT_EQ(processors("0::/\n"), std::nullopt);
    write("jobs/mine/cpu.max", "max 100000");
    EXPECT_EQ(processors("0::/jobs/mine\n"), std::nullopt);
    write("jobs/cpu.max", "300000 100000");
    EXPECT_EQ(processors("0::/jobs/mine\n"), 3U);
    write("jobs/mine/cpu.max", "800000 100000");
    EXPECT_EQ(processors("0::/jobs/mine\n"), 3U);
    write("jobs/mine/cpu.max", "50000 100000");
    EXPECT_EQ(processors("0::/jobs/mine\n"), 1U);
    EXPECT_EQ(processors("0::/other\n"), std::nullopt);
}

TEST_F(ControlGroups, InAContainerTheGroupIsWhatIsMounted)
{
    write("cpu.max", "250000 100000");
    EXPECT_EQ(processors("0::/docker/0123456789\n"), 3U);
}

TEST_F(ControlGroups, OfVersionOneOnlyTheProcessorsCount)
{
    write("cpu,cpuacct/slice/cpu.cfs_quota_us", "600000");
    write("cpu,cpuacct/slice/cpu.cfs_period_us", "100000");
    write("memory/slice/cpu.cfs_quota_us", "100000");
    write("memory/slice/cpu.cfs_period_us", "100000");
    EXPECT_EQ(processors("4:memory:/slice\n3:cpu,cpuacct:/slice\n0::/\n"), 6U);
    EXPECT_EQ(processors("4:memory:/slice\n2:cpuset:/slice\n"), std::nullopt);
    for (const char* odd : {"", "\n", "x", "3:cpu", "3:cpu:", ":::"})
        EXPECT_EQ(processors(odd), std::nullopt) << odd;
}

#if defined(__linux__)
TEST(Processors, AffinityCounts)
{
    cpu_set_t before;
    ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
    EXPECT_LE(availableProcessors(), static_cast<unsigned>(CPU_COUNT(&before)));
    int first = 0;
    while (!CPU_ISSET(first, &before))
        ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    EXPECT_EQ(availableProcessors(), 1U);
    ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}
#endif
}  // namespace
}  // namespace specplan::util
