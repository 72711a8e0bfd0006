// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace specplan::validity
{
/// How a pool of workers goes about its work: what ThreadPoolExecutor does and SimulatedPool predicts.
struct PoolRules
{
    /// From two up to this many workers the search thread is one of them.
    static constexpr unsigned kFewWorkers = 8;

    /// How long a thread spins before it sleeps: as long as waking it would take.
    static constexpr double kSpinSeconds = 20e-6;

    [[nodiscard]] static constexpr bool searchThreadWorks(unsigned workers) noexcept
    {
        return workers > 1 && workers <= kFewWorkers;
    }
};
}  // namespace specplan::validity
