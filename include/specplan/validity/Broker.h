// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "specplan/validity/CheckSource.h"
#include "specplan/validity/CheckStatistics.h"
#include "specplan/validity/CostMeter.h"
#include "specplan/validity/Executor.h"
#include "specplan/validity/SpeculationAccounts.h"
#include "specplan/validity/VerdictTable.h"

namespace specplan::validity
{
/// Stands between a search and the checks: knows every verdict, runs what is missing, and never runs a check twice.
///
/// The broker measures what checks cost. Where handing them over would cost more than it saves it runs them right away
/// in the search thread, and asks nobody for checks to run ahead.
///
/// Threads: search thread only; the executor is the one place where threads meet.
class Broker
{
public:
    /// \param executor must outlive the broker.
    explicit Broker(Executor& executor);

    /// Where to get checks that run ahead while the search waits; nullptr for none.
    void setSource(CheckSource* source) noexcept
    {
        source_ = source;
    }

    /// If true, every wait lasts until all checks are back, speculative ones too (the paper's barrier).
    void setBarrier(bool barrier) noexcept
    {
        barrier_ = barrier;
    }

    /// As long as all checks together have taken no longer than this (seconds), other threads are left alone, unless a
    /// single check takes longer than to wake one.
    void setWarmUp(double seconds) noexcept
    {
        warmUp_ = seconds;
    }

    /// Asked now and then during waits and long checks; once it returns true, `demand` gives up, and no check begins
    /// until `settle` or `setInterrupt` is called. Empty for never.
    void setInterrupt(std::function<bool()> interrupt)
    {
        executor_.stopSignal().watch(std::move(interrupt));
    }

    /// Asks right now. \return whether to stop. \throws what the interrupt throws.
    [[nodiscard]] bool isInterrupted()
    {
        return executor_.stopSignal().ask();
    }

    /// Makes all these verdicts known. Checks that are missing run at the same time where the executor has workers.
    /// \return false if interrupted; the call may be repeated later, and loses nothing but motions that were broken
    /// off. \throws what the first of these checks, in the order given, threw. After `settle` asking again runs that
    /// check again.
    [[nodiscard]] bool demand(std::span<const CheckId> checks);

    /// Gives the workers more to do if they run dry, while the search has no need to wait. Costs next to nothing if
    /// they do not. `demand` does the same when all is known.
    void feed();

    /// Whether workers have nothing left to begin, or the search is to stop: a source that is thinking should come to
    /// an end. Cheap.
    [[nodiscard]] bool workersRunDry()
    {
        return executor_.runsDry() || executor_.stopSignal().askNowAndThen();
    }

    /// Hands a check out ahead of demand.
    /// \return false if it is known, in flight, failed, or the executor runs inline.
    bool prefetch(CheckId check);

    [[nodiscard]] Verdict verdict(CheckId check) const noexcept
    {
        return table_.verdict(check);
    }

    /// Whether the search of this query has asked for this verdict and got it.
    [[nodiscard]] bool isUsed(CheckId check) const noexcept
    {
        return table_.usedIn(check) == query_;
    }

    /// Enters a verdict that is known from elsewhere.
    void setVerdict(CheckId check, bool valid);

    /// Begins another query over the same verdicts: statistics count from 0 again. To be called when settled.
    void beginQuery();

    /// Drops what has not started, waits until nothing runs, and forgets failures.
    void settle();

    [[nodiscard]] const CheckStatistics& statistics() const noexcept
    {
        return statistics_;
    }

    [[nodiscard]] double now() const noexcept
    {
        return executor_.now();
    }

private:
    using Entry = VerdictTable::Entry;
    class HandOverTimer;

    /// Whether to stop; asks now and then. \throws what the interrupt throws.
    [[nodiscard]] bool stops()
    {
        return executor_.stopSignal().askNowAndThen() && executor_.stopSignal().ask();
    }
    [[nodiscard]] bool demandMissing(std::span<const CheckId> checks);
    [[nodiscard]] bool runHere();
    [[nodiscard]] bool shouldRunHere(CheckId check) const;
    [[nodiscard]] CostMeter& costOf(CheckId check) noexcept
    {
        return cost_[check.isMotion() ? 1 : 0];
    }
    /// Whether nothing that the search asks for is worth handing out.
    [[nodiscard]] bool allCheap() const noexcept
    {
        return cost_[0].isCheap() && (cost_[1].isCheap() || cost_[1].knowsNothing());
    }
    void submit(CheckId check, Urgency urgency);
    void countGain(CheckId check, double times);
    void runAheadHere(CheckId check, Entry& entry);
    void recordHere(CheckId check, Entry& entry);
    void settleAccounts();
    unsigned handOut();
    [[nodiscard]] bool waitForMissing();
    [[nodiscard]] std::optional<CheckId> submitMissing();
    void runOwn(CheckId check);
    void runAndTell(CheckId check);
    void noteReady(Entry& entry);
    void askSource();
    void noteThought();
    void dropUnwanted();
    void drop(std::span<const CheckId> checks);
    void collect(std::chrono::milliseconds patience);
    void tellSource();
    void record(Completion& completion);
    void noteUse(Entry& entry);
    [[nodiscard]] bool isUsed(const Entry& entry) const noexcept
    {
        return entry.usedIn == query_;
    }
    [[noreturn]] void rethrow(CheckId check);

    Executor& executor_;
    SpeculationAccounts accounts_;
    CheckSource* source_ = nullptr;
    bool barrier_ = false;
    bool sourceListens_ = true;  ///< the source has been told every verdict
    bool runsAlone_ = false;     ///< checks are so cheap that the search runs all of them, and asks nobody
    bool sawInvalid_ = false;    ///< since queued checks were last looked through
    double warmUp_ = 1e-3;
    std::uint64_t submitted_ = 0;   ///< to other threads
    std::optional<double> leftAt_;  ///< time at which the search last had checks handed out; none between searches
    unsigned chances_ = 0;          ///< how often it could have since
    double secondsEver_ = 0.0;      ///< of all checks, in all queries
    bool thought_ = false;          ///< what is handed out now the source had to think of
    VerdictTable table_;
    std::uint16_t query_ = 1;
    std::array<CostMeter, 2> cost_;                 ///< of states and of motions, which cost different amounts
    std::map<CheckId, std::exception_ptr> errors_;  ///< of the entries marked failed
    std::vector<CheckId> missing_;                  ///< asked for and not known, in order
    std::size_t awaited_ = 0;                       ///< entries marked awaited
    std::vector<CheckId> proposals_;
    std::vector<CheckId> dropped_;
    std::vector<Completion> completions_;
    CheckStatistics statistics_;
};
}  // namespace specplan::validity
