// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace specplan::validity
{
/// Counts of checks. Two sums always hold once the broker has settled:
///   speculativeChecks = speculativeUsed + speculativeWasted() + speculativeDropped
///   checksUsed        = usedReady + usedAfterWait + usedInline
struct CheckStatistics
{
    std::uint64_t checksUsed = 0;      ///< different checks whose verdict the search has asked for
    std::uint64_t checksReused = 0;    ///< verdicts of earlier queries that the search has asked for; not in checksUsed
    std::uint64_t checksRun = 0;       ///< checks that were run, needed or not
    std::uint64_t demandedChecks = 0;  ///< checks run because the search asked
    std::uint64_t speculativeChecks = 0;   ///< checks handed out ahead of demand
    std::uint64_t speculativeUsed = 0;     ///< of these, used later
    std::uint64_t speculativeReady = 0;    ///< of these, finished when the search first asked
    std::uint64_t speculativeDropped = 0;  ///< handed out and taken back before they started
    std::uint64_t usedReady = 0;           ///< verdict was there when first asked for
    std::uint64_t usedAfterWait = 0;       ///< the search waited for a worker
    std::uint64_t usedInline = 0;          ///< the search thread ran the check itself
    std::uint64_t failuresForgotten = 0;   ///< checks that threw and were not needed (so far)
    double waitSeconds = 0.0;              ///< time in which the search stood still for checks, executor's clock
    double usedSeconds = 0.0;              ///< sum of the durations of all used checks
    double runSeconds = 0.0;               ///< sum of the durations of all checks run

    [[nodiscard]] std::uint64_t speculativeWasted() const noexcept
    {
        return speculativeChecks - speculativeUsed - speculativeDropped;
    }

    /// Speculative checks used / run; 1 if there were none.
    [[nodiscard]] double accuracy() const noexcept
    {
        return ratio(speculativeUsed, speculativeChecks - speculativeDropped, 1.0);
    }

    /// Used verdicts that came from speculation / all used verdicts; 0 if there were none.
    [[nodiscard]] double coverage() const noexcept
    {
        return ratio(speculativeUsed, checksUsed, 0.0);
    }

    /// Speculative verdicts ready when first asked for / speculative verdicts used; 1 if there were none.
    [[nodiscard]] double timeliness() const noexcept
    {
        return ratio(speculativeReady, speculativeUsed, 1.0);
    }

private:
    [[nodiscard]] static double ratio(std::uint64_t part, std::uint64_t whole, double none) noexcept
    {
        return whole == 0 ? none : static_cast<double>(part) / static_cast<double>(whole);
    }
};
}  // namespace specplan::validity
