// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/RunningClock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace specplan::validity
{
namespace
{
TEST(RunningClock, CountsWorkAndLeavesOutWhatIsNone)
{
    RunningClock clock;
    static_cast<void>(clock.seconds());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const double begin = clock.seconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const double rested = clock.seconds();
    EXPECT_GE(rested, begin);
    EXPECT_LT(rested - begin, 0.025) << "asleep";
    const double processor = threadCpuSeconds();
    const double start = steadySeconds();
    while (threadCpuSeconds() - processor < 0.02)
        static_cast<void>(clock.seconds());
    const double worked = clock.seconds() - rested;
    EXPECT_GT(worked, 0.019);
    EXPECT_LE(worked, steadySeconds() - start + 1e-3);
}
}  // namespace
}  // namespace specplan::validity
