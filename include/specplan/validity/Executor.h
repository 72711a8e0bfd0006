// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <vector>

#include "specplan/validity/Checker.h"
#include "specplan/validity/StopSignal.h"

namespace specplan::validity
{
/// A check that has been run.
struct Completion
{
    CheckId check;
    bool valid = false;
    double seconds = 0.0;      ///< duration of the check, in the executor's time
    bool here = false;         ///< whether the search thread ran it
    bool measured = true;      ///< whether `seconds` is this check's own duration, not that of one before it
    double busyShare = -1.0;   ///< share of that time spent on a processor; negative if not measured
    bool brokenOff = false;    ///< the check was told to stop and has no verdict
    std::exception_ptr error;  ///< what the check threw; `valid` means nothing then
};

enum class Urgency
{
    Speculative,
    Demanded  ///< starts before every speculative check that has not started
};

/// Runs checks: in the calling thread, in a pool, or on a virtual clock.
///
/// Nothing begins while the stop signal is set: what is queued then stays there until it is taken back or the signal is
/// released.
///
/// Threads: every member is for the search thread, which also is the one that receives the completions.
class Executor
{
public:
    Executor() = default;
    virtual ~Executor() = default;
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;

    /// Tells those who run checks to stop.
    [[nodiscard]] StopSignal& stopSignal() noexcept
    {
        return stop_;
    }

    /// How many checks may run at once, at least 1.
    [[nodiscard]] virtual unsigned workers() const noexcept = 0;

    /// Whether there is nobody but the calling thread to run checks, so that it makes no sense to submit ahead of need.
    [[nodiscard]] virtual bool runsInline() const noexcept = 0;

    /// Whether `runHere` may be called now.
    [[nodiscard]] virtual bool canRunHere() const noexcept = 0;

    /// Whether the calling thread is one of the workers, so that it should run a check rather than wait for one. Then
    /// `runHere` may be called, too.
    [[nodiscard]] virtual bool worksHere() const noexcept = 0;

    /// Runs a check in the calling thread before it returns.
    [[nodiscard]] virtual Completion runHere(CheckId check) = 0;

    /// Workers that would start a check at once.
    [[nodiscard]] virtual unsigned freeWorkers() const noexcept = 0;

    /// The search has not been waiting for so many seconds: for as long `room` should last.
    virtual void searchThought(double)
    {
    }

    /// How many more checks it makes sense to submit: free workers, and a small supply so that none of them runs dry.
    [[nodiscard]] virtual unsigned room() const noexcept = 0;

    /// Whether workers that have been used have nothing left to begin, and may be waiting for more. Cheap: asked often.
    [[nodiscard]] virtual bool runsDry() = 0;

    /// Whether checks are queued, running, or finished and not collected.
    [[nodiscard]] virtual bool busy() const noexcept = 0;

    /// Hands over a check. Each check may be in hand once at a time.
    virtual void submit(CheckId check, Urgency urgency) = 0;

    /// Makes a submitted speculative check a demanded one; without effect if it has started.
    virtual void promote(CheckId check) = 0;

    /// Appends what has finished since the last call, in order of finishing.
    /// \param patience how long to wait for the first completion; 0 does not wait. Nothing to wait for: returns at
    /// once. Instead of waiting the calling thread may run a submitted check itself, and takes as long as that takes.
    virtual void collect(std::vector<Completion>& out, std::chrono::milliseconds patience) = 0;

    /// Takes back the checks that have not started, and appends them to `dropped`.
    virtual void cancelQueued(std::vector<CheckId>& dropped) = 0;

    /// Takes back the speculative checks that have not started and that nobody wants any more.
    virtual void cancelUnwanted(const std::function<bool(CheckId)>& isWanted, std::vector<CheckId>& dropped) = 0;

    /// Seconds on the executor's clock: real time, or virtual time.
    [[nodiscard]] virtual double now() const noexcept = 0;

protected:
    StopSignal stop_;
};
}  // namespace specplan::validity
