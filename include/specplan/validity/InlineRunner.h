// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/validity/Executor.h"
#include "specplan/validity/RunCheck.h"

namespace specplan::validity
{
/// Runs checks in the calling thread and measures them.
///
/// Reading the clock costs as much as a cheap check: of checks below a microsecond every 16th is measured and stands
/// for the others.
class InlineRunner
{
public:
    [[nodiscard]] Completion run(Checker& checker, CheckId check, unsigned worker) noexcept
    {
        const bool sampled = lastSeconds_ > kLongSeconds || count_++ % kSampleEvery == 0;
        if (lastSeconds_ < kCheapSeconds && !sampled)
        {
            Completion completion = runCheckUnmeasured(checker, check, worker);
            completion.seconds = lastSeconds_;
            completion.measured = false;
            return completion;
        }
        const double cpu = sampled ? threadCpuSeconds() : 0.0;
        Completion completion = runCheck(checker, check, worker);
        if (sampled && completion.seconds > kCheapSeconds)
            completion.busyShare = (threadCpuSeconds() - cpu) / completion.seconds;
        lastSeconds_ = completion.seconds;
        return completion;
    }

private:
    static constexpr double kCheapSeconds = 1e-6;
    static constexpr double kLongSeconds = 50e-6;
    static constexpr unsigned kSampleEvery = 16;

    double lastSeconds_ = 1.0;  ///< duration of the last check that was measured
    unsigned count_ = 0;
};
}  // namespace specplan::validity
