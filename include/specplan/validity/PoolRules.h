// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/validity/StopSignal.h"

namespace specplan::validity
{
/// How a pool of workers goes about its work: what ThreadPoolExecutor does and SimulatedPool predicts.
struct PoolRules
{
    /// From two up to this many workers the search thread is one of them.
    static constexpr unsigned kFewWorkers = 8;

    /// How long a thread spins before it sleeps. The search thread: as long as waking it would take. A worker longer,
    /// since it is the search that has to wake it, and on a virtual machine that takes 20 to 50 µs.
    static constexpr double kSearchSpins = 20e-6;
    static constexpr double kWorkerSpins = 100e-6;

    /// A search thread that is in a check cannot ask whether to stop, and the others wait for that: where checks take
    /// longer than StopSignal::kTrust it leaves them to a thread of their own. (Where they do SimulatedPool lets the
    /// search thread work all the same, which takes as long.) Not the same limit both ways, so that it does not waver.
    [[nodiscard]] static constexpr bool isLong(double seconds, bool wasLong) noexcept
    {
        return seconds > (wasLong ? StopSignal::kTrust / 2.0 : StopSignal::kTrust);
    }

    [[nodiscard]] static constexpr bool searchThreadWorks(unsigned workers) noexcept
    {
        return workers > 1 && workers <= kFewWorkers;
    }
};
}  // namespace specplan::validity
