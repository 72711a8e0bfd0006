// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace specplan::validity
{
/// Running averages of the durations of checks.
class Durations
{
public:
    void add(double seconds) noexcept
    {
        const double share = none_ ? 1.0 : kUpdate;
        mean_ += (seconds - mean_) * share;
        meanSquare_ += (seconds * seconds - meanSquare_) * share;
        none_ = false;
    }

    /// Seconds; 1 as long as nothing is known.
    [[nodiscard]] double mean() const noexcept
    {
        return mean_;
    }

    /// How many average checks fit into the one that runs at some moment, on average: 1 if all take the same, more if
    /// there are long ones among short ones.
    [[nodiscard]] double spread() const noexcept
    {
        return mean_ > 0.0 ? std::max(meanSquare_ / (mean_ * mean_), 1.0) : 1.0;
    }

private:
    /// Share of the newest check.
    static constexpr double kUpdate = 0.05;

    double mean_ = 1.0;
    double meanSquare_ = 1.0;
    bool none_ = true;
};

/// How a pool of workers goes about its work: what ThreadPoolExecutor does and SimulatedPool predicts.
struct PoolRules
{
    /// From two up to this many workers the search thread is one of them.
    static constexpr unsigned kFewWorkers = 8;

    /// How long a thread spins before it sleeps: as long as waking it would take.
    static constexpr double kSpinSeconds = 20e-6;

    /// What the supply of queued checks has to bridge: the time that the search may take until it hands out more.
    static constexpr double kSupplySeconds = 40e-6;

    [[nodiscard]] static constexpr bool searchThreadWorks(unsigned workers) noexcept
    {
        return workers > 1 && workers <= kFewWorkers;
    }

    /// Checks that may be in hand: one for each worker and a supply. A search thread that works comes back after a
    /// check, and until then the others live on the supply; the more so where it may be a long one and theirs are
    /// short.
    [[nodiscard]] static std::size_t mostInHand(unsigned workers, bool searchThreadWorks,
                                                const Durations& durations) noexcept
    {
        constexpr double kMostSpread = 8.0;
        const double aCheck = searchThreadWorks ? std::min(2.0 * durations.spread() - 1.0, kMostSpread) : 0.0;
        const double aThought = std::min(kSupplySeconds / std::max(durations.mean(), 1e-9), 4.0);
        return workers + static_cast<std::size_t>(workers * std::max(aCheck, aThought));
    }
};
}  // namespace specplan::validity
