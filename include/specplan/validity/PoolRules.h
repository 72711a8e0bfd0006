// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace specplan::validity
{
/// How a pool of workers goes about its work: what ThreadPoolExecutor does and SimulatedPool predicts.
struct PoolRules
{
    /// From two up to this many workers the search thread is one of them.
    static constexpr unsigned kFewWorkers = 8;

    /// How long a thread spins before it sleeps: as long as waking it would take.
    static constexpr double kSpinSeconds = 20e-6;

    /// What the supply of queued checks has to bridge: the time that the search may take until it hands out more.
    static constexpr double kSupplySeconds = 40e-6;

    /// Share of the newest check in the average duration.
    static constexpr double kAverageUpdate = 0.05;

    [[nodiscard]] static constexpr bool searchThreadWorks(unsigned workers) noexcept
    {
        return workers > 1 && workers <= kFewWorkers;
    }

    /// Checks that may be in hand. A search thread that works comes back after a check: until then the others live on
    /// the supply. \param meanSeconds duration of a check.
    [[nodiscard]] static std::size_t mostInHand(unsigned workers, bool searchThreadWorks, double meanSeconds) noexcept
    {
        const double supply =
            std::floor(std::clamp(workers * kSupplySeconds / std::max(meanSeconds, 1e-9), 0.0, 4.0 * workers));
        return workers + std::max(searchThreadWorks ? workers : 0U, static_cast<unsigned>(supply));
    }
};

/// Running average of the durations of checks.
class MeanDuration
{
public:
    void add(double seconds) noexcept
    {
        seconds_ = none_ ? seconds : seconds_ + (seconds - seconds_) * PoolRules::kAverageUpdate;
        none_ = false;
    }

    /// 1 as long as nothing is known.
    [[nodiscard]] double seconds() const noexcept
    {
        return seconds_;
    }

private:
    double seconds_ = 1.0;
    bool none_ = true;
};
}  // namespace specplan::validity
