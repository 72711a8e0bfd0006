// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>

namespace specplan::validity
{
/// Tells whether checks are too cheap to be handed to another thread, by a majority among the last ones measured: an
/// outlier changes nothing, a lasting change does within eight checks.
class CostMeter
{
public:
    void add(double seconds) noexcept
    {
        // Not the same limit both ways, so that costs near it do not make it waver.
        const bool dear = seconds > (isCheap() && count_ > 0 ? kDear : kCheap);
        dear_ = static_cast<std::uint16_t>((dear_ << 1U | (dear ? 1U : 0U)) & kWindow);
        count_ += count_ < kMeasured ? 1U : 0U;
    }

    /// False as long as nothing is known.
    [[nodiscard]] bool isCheap() const noexcept
    {
        return count_ > 0 && 2U * static_cast<unsigned>(std::popcount(dear_)) < count_;
    }

    [[nodiscard]] bool knowsNothing() const noexcept
    {
        return count_ == 0;
    }

private:
    /// Handing a check to another thread and taking it back costs the search 1 to 3 µs, and more where threads share
    /// cores.
    static constexpr double kCheap = 6e-6;
    static constexpr double kDear = 9e-6;
    static constexpr unsigned kMeasured = 15;
    static constexpr unsigned kWindow = (1U << kMeasured) - 1U;

    std::uint16_t dear_ = 0;  ///< one bit for each of the last checks, newest lowest
    unsigned count_ = 0;
};
}  // namespace specplan::validity
