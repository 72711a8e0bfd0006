// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

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
    /// \param measuresAll whether to measure cheap checks too.
    explicit InlineRunner(bool measuresAll = false) : cheapSeconds_(measuresAll ? 0.0 : kCheapSeconds)
    {
    }

    [[nodiscard]] Completion run(Checker& checker, CheckId check, unsigned worker) noexcept
    {
        double& lastSeconds = lastSeconds_[check.isMotion() ? 1 : 0];
        const bool sampled = lastSeconds > kLongSeconds || count_++ % kSampleEvery == 0;
        if (lastSeconds < cheapSeconds_ && !sampled)
        {
            Completion completion = runCheckUnmeasured(checker, check, worker);
            completion.seconds = lastSeconds;
            completion.measured = false;
            return completion;
        }
        const double cpu = sampled ? threadCpuSeconds() : 0.0;
        Completion completion = runCheck(checker, check, worker);
        if (completion.brokenOff)
        {
            completion.measured = false;
            return completion;
        }
        if (sampled && completion.seconds > kCheapSeconds)
            completion.busyShare = (threadCpuSeconds() - cpu) / completion.seconds;
        lastSeconds = completion.seconds;
        return completion;
    }

private:
    static constexpr double kCheapSeconds = 1e-6;
    static constexpr double kLongSeconds = 50e-6;
    static constexpr unsigned kSampleEvery = 16;

    double cheapSeconds_;                          ///< shorter checks are not all measured
    std::array<double, 2> lastSeconds_{1.0, 1.0};  ///< duration of the last state and motion that was measured
    unsigned count_ = 0;
};
}  // namespace specplan::validity
