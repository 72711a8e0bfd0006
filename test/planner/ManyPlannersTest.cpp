// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "ManyPlanners.h"
#include "ProcessCounts.h"

namespace specplan::test
{
namespace
{
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr bool kMeasuresMemory = false;  // sanitizers keep what is freed
#else
constexpr bool kMeasuresMemory = true;
#endif

TEST(ManyPlanners, AreMadeUsedAndDestroyedEightAtATimeWithoutGrowth)
{
    const std::int64_t states = FaultyProblem::livingStates();
    ManyPlanners planners;
    (void)planners.run(100, 8);  // what a process takes once, it has now
    const ProcessCounts before = ProcessCounts::now();
    (void)planners.run(300, 8);
    const ProcessCounts after = ProcessCounts::now();
    EXPECT_EQ(FaultyProblem::livingStates(), states);
    EXPECT_EQ(after.threads, before.threads);
    EXPECT_EQ(after.files, before.files);
    if (kMeasuresMemory)
    {
        EXPECT_LT(after.kilobytes, before.kilobytes + 16 * 1024);
    }
}
}  // namespace
}  // namespace specplan::test
