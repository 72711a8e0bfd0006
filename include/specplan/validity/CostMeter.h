// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace specplan::validity
{
/// Tells whether checks are too cheap to be handed to another thread, by the mean of the last ones measured. The
/// longest of them is left out: one outlier changes nothing, but a few long checks among many short ones count for what
/// they cost.
class CostMeter
{
public:
    void add(double seconds) noexcept
    {
        last_[next_] = seconds;
        next_ = (next_ + 1) % kWindow;
        count_ += count_ < kWindow ? 1 : 0;
        const auto end = last_.begin() + static_cast<std::ptrdiff_t>(count_);
        const double sum = std::accumulate(last_.begin(), end, 0.0);
        const double rest = count_ > 1 ? sum - *std::max_element(last_.begin(), end) : sum;
        const double mean = rest / static_cast<double>(std::max<std::size_t>(count_ - 1, 1));
        mean_ = sum / static_cast<double>(count_);
        // Not the same limit both ways, so that costs near it do not make it waver.
        cheap_ = mean < (cheap_ ? kDear : kCheap);
    }

    /// False as long as nothing is known.
    [[nodiscard]] bool isCheap() const noexcept
    {
        return cheap_;
    }

    [[nodiscard]] bool knowsNothing() const noexcept
    {
        return count_ == 0;
    }

    /// Mean of the last ones measured, seconds; 0 if nothing is known.
    [[nodiscard]] double mean() const noexcept
    {
        return mean_;
    }

private:
    /// Handing a check to another thread and taking it back costs the search 1 to 3 µs, and more where threads share
    /// cores.
    static constexpr double kCheap = 4e-6;
    static constexpr double kDear = 6e-6;
    static constexpr std::size_t kWindow = 24;

    std::array<double, kWindow> last_{};
    std::size_t next_ = 0;
    std::size_t count_ = 0;
    double mean_ = 0.0;
    bool cheap_ = false;
};
}  // namespace specplan::validity
