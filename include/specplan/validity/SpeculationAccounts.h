// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/validity/Executor.h"

namespace specplan::validity
{
/// Keeps the accounts of running ahead: what the search spends on finding checks and on handing them over, and what
/// it is saved by other threads that run them. Where it does not pay it gets a rest, longer each time.
///
/// All times are seconds on the executor's clock; on a virtual one thinking takes no time, and everything pays.
///
/// Threads: search thread only.
class SpeculationAccounts
{
public:
    /// What it costs the search to hand a check to another thread and to take it back, at least.
    static constexpr double kHandOver = 2e-6;

    /// \param executor has the clock; must outlive the accounts.
    explicit SpeculationAccounts(const Executor& executor) : executor_(executor)
    {
    }

    /// The source was asked, and took so long.
    void addThought(double seconds) noexcept
    {
        if (!beginsAnew_)  // to begin anew after a rest takes long, and says nothing
            thought_ += seconds;
        beginsAnew_ = false;
    }

    /// Handing checks over took so much longer than usual.
    void addHandOver(double seconds) noexcept
    {
        handOver_ += seconds;
    }

    /// A check of this duration was handed over, or with `times` -1 came back unused. \param thoughtOf whether the
    /// source had to think to name it.
    void addGain(double seconds, bool thoughtOf, double times) noexcept;

    /// Draws the balance. \param runSeconds of all checks so far.
    /// \return whether a rest begins now.
    [[nodiscard]] bool settle(double runSeconds) noexcept;

    /// Whether the source is not to be asked.
    [[nodiscard]] bool sourceRests() const noexcept
    {
        return restsUntil_ != 0.0 && executor_.now() < restsUntil_;
    }

    /// Whether nobody is to be woken either: on a busy machine a thread that is woken may take the search's own
    /// processor, and handing over comes to cost more than to check.
    [[nodiscard]] bool workersRest() const noexcept
    {
        return handOverIsDear_ && sourceRests();
    }

private:
    /// How long a rest is at first, as a multiple of what was spent in vain.
    static constexpr double kRest = 10.0;

    const Executor& executor_;
    double thought_ = 0.0;         ///< spent on the source's proposals since the last balance
    double handOver_ = 0.0;        ///< spent on handing over since then, more than usual
    double thoughtGain_ = 0.0;     ///< saved since then by checks for which the source had to think
    double gain_ = 0.0;            ///< saved by all of them
    double restsUntil_ = 0.0;      ///< 0: there was no rest yet
    double nextRest_ = kRest;      ///< as a multiple, too
    bool handOverIsDear_ = false;  ///< and that is why the source rests
    bool beginsAnew_ = false;      ///< there was a rest since the source was last asked
};
}  // namespace specplan::validity
