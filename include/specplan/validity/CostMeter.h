// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/validity/MajorityVote.h"

namespace specplan::validity
{
/// Tells whether checks are too cheap to be handed to another thread.
class CostMeter
{
public:
    void add(double seconds) noexcept
    {
        // Not the same limit both ways, so that costs near it do not make it waver.
        cheap_.add(seconds < (isCheap() ? kDear : kCheap));
    }

    /// False as long as nothing is known.
    [[nodiscard]] bool isCheap() const noexcept
    {
        return cheap_.yes();
    }

    [[nodiscard]] bool knowsNothing() const noexcept
    {
        return cheap_.isEmpty();
    }

private:
    /// Handing a check to another thread and taking it back costs the search 1 to 3 µs, and more where threads share
    /// cores.
    static constexpr double kCheap = 6e-6;
    static constexpr double kDear = 9e-6;

    MajorityVote cheap_;
};
}  // namespace specplan::validity
