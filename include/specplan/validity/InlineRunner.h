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
        if (lastSeconds_ < kCheapSeconds && ++unmeasured_ < kSampleEvery)
        {
            Completion completion = runCheckUnmeasured(checker, check, worker);
            completion.seconds = lastSeconds_;
            return completion;
        }
        Completion completion = runCheck(checker, check, worker);
        lastSeconds_ = completion.seconds;
        unmeasured_ = 0;
        return completion;
    }

private:
    static constexpr double kCheapSeconds = 1e-6;
    static constexpr unsigned kSampleEvery = 16;

    double lastSeconds_ = 1.0;  ///< duration of the last check that was measured
    unsigned unmeasured_ = 0;   ///< checks since then
};
}  // namespace specplan::validity
