// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "specplan/lattice/CheckId.h"

namespace specplan::validity
{
/// Numbers of states and of motions.
using CountByKind = std::array<std::size_t, 2>;

[[nodiscard]] inline std::size_t kindOf(lattice::CheckId check) noexcept
{
    return check.isMotion() ? 1 : 0;
}

/// How many checks a pool should have queued, by the time that they are likely to take: counts alone would not do,
/// since ten cheap states are gone before the search thread is back from one long motion.
class Supply
{
public:
    /// How long a check has taken.
    void learn(lattice::CheckId check, double seconds) noexcept
    {
        durations_[kindOf(check)].add(seconds);
        all_.add(seconds);
    }

    /// Mean duration of states (0) or motions (1); 0 if none is known.
    [[nodiscard]] double mean(std::size_t kind) const noexcept
    {
        return durations_[kind].mean();
    }

    /// How long the search was away, thinking.
    void learnThought(double seconds) noexcept
    {
        thoughts_.add(seconds);
    }

    /// How many more checks to hand out: one for each worker that has none, and so many more that none runs dry until
    /// the search comes back. Where it runs checks itself it is away for one of these, or for as long as it usually
    /// thinks; with many workers it comes back all the time.
    [[nodiscard]] unsigned room(unsigned workers, bool searchThreadWorks, std::size_t inHand,
                                const CountByKind& queued) const noexcept
    {
        const std::size_t most = std::size_t{workers} * kMostPerWorker;
        const std::size_t free = inHand < workers ? workers - inHand : 0;
        if (!all_.known() || inHand >= most)
            return static_cast<unsigned>(free);
        const double away = searchThreadWorks ? std::max(durations_[0].typical(), durations_[1].typical()) : 0.0;
        const double least = std::min(kThoughtSeconds, kMostThoughts * all_.mean());
        const double thought = searchThreadWorks ? std::max(least, thoughts_.typical()) : least;
        const std::size_t running = inHand - std::min(inHand, queued[0] + queued[1]);
        const auto idle = static_cast<double>(workers - std::min<std::size_t>(running, workers));  // take one at once
        const double missing = workers * std::max(away, thought) + idle * all_.mean() - expected(queued);
        const double count =
            std::clamp(missing / std::max(all_.mean(), kLeastSeconds), 0.0, static_cast<double>(most - inHand));
        return static_cast<unsigned>(std::max(free, static_cast<std::size_t>(count)));
    }

private:
    /// The time that the search may take until it hands out more, at least.
    static constexpr double kThoughtSeconds = 40e-6;
    static constexpr double kMostThoughts = 4.0;
    static constexpr std::size_t kMostPerWorker = 24;
    static constexpr double kLeastSeconds = 1e-9;

    /// Running averages.
    class Durations
    {
    public:
        void add(double seconds) noexcept
        {
            const double share = known_ ? kUpdate : 1.0;
            mean_ += (seconds - mean_) * share;
            meanSquare_ += (seconds * seconds - meanSquare_) * share;
            known_ = true;
        }

        [[nodiscard]] bool known() const noexcept
        {
            return known_;
        }

        [[nodiscard]] double mean() const noexcept
        {
            return mean_;
        }

        /// How long the check takes that runs at some moment: long ones run for a greater part of the time.
        [[nodiscard]] double typical() const noexcept
        {
            return mean_ > 0.0 ? std::clamp(meanSquare_ / mean_, mean_, kMostSpread * mean_) : 0.0;
        }

    private:
        static constexpr double kUpdate = 0.05;  ///< share of the newest check
        static constexpr double kMostSpread = 4.0;

        double mean_ = 0.0;
        double meanSquare_ = 0.0;
        bool known_ = false;
    };

    /// Seconds of the checks that are queued. A kind that is not known counts as average.
    [[nodiscard]] double expected(const CountByKind& queued) const noexcept
    {
        double seconds = 0.0;
        for (std::size_t kind = 0; kind < queued.size(); ++kind)
            seconds +=
                static_cast<double>(queued[kind]) * (durations_[kind].known() ? durations_[kind].mean() : all_.mean());
        return seconds;
    }

    std::array<Durations, 2> durations_;  ///< of states, of motions
    Durations all_;
    Durations thoughts_;
};
}  // namespace specplan::validity
