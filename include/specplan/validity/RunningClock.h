// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "specplan/validity/RunCheck.h"

namespace specplan::validity
{
/// Seconds that the calling thread has been running, without the times in which the system gave the processor to
/// others.
///
/// Asking the system for that takes too long to be done often. A thread that loses its processor loses it for some
/// while: only when more than that while has passed since the last call is the system asked.
///
/// Threads: always the same one. Call it often.
class RunningClock
{
public:
    [[nodiscard]] double seconds() noexcept
    {
        const double now = steadySeconds();
        if (now - last_ > kWhile)
        {
            const double processor = threadCpuSeconds();
            if (processor_ >= 0.0)
                lost_ += std::clamp((now - asked_) - (processor - processor_), 0.0, now - last_);
            asked_ = now;
            processor_ = processor;
        }
        last_ = now;
        return now - lost_;
    }

private:
    static constexpr double kWhile = 100e-6;

    double last_ = 0.0;        ///< last call
    double asked_ = 0.0;       ///< when the system was asked last
    double processor_ = -1.0;  ///< what it said
    double lost_ = 0.0;
};
}  // namespace specplan::validity
