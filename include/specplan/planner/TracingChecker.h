// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "specplan/planner/CheckTrace.h"
#include "specplan/planner/OmplChecker.h"

namespace specplan::planner
{
/// Stands before the checker and keeps a trace: notes what the checks find and how long they take; or, replaying, knows
/// that from the trace and runs only those checks that are not in it, once.
///
/// Threads: as OmplChecker; `absorb` and `notes` by the search thread while nothing runs. A replay has one worker.
class TracingChecker : public validity::Checker
{
public:
    /// One check that has run. `start` is on the steady clock.
    struct Note
    {
        validity::CheckId check;
        bool valid;
        double start;
        double seconds;
        unsigned worker;
    };

    TracingChecker(OmplChecker& checker, unsigned workers, std::shared_ptr<CheckTrace> trace, bool replays)
        : checker_(checker), trace_(std::move(trace)), replays_(replays), workers_(workers)
    {
    }

    bool check(validity::CheckId check, unsigned worker) override;

    [[nodiscard]] bool stopsInside() const noexcept override
    {
        return checker_.stopsInside();
    }

    /// Duration of the last check of a replay.
    [[nodiscard]] double lastSeconds() const noexcept
    {
        return lastSeconds_;
    }

    /// See CheckTrace::afterCheck().
    [[nodiscard]] double afterCheck() const noexcept
    {
        return trace_->afterCheck();
    }

    /// Puts what has been noted since the last time into the trace.
    void absorb();

    /// All checks that have run, in the order in which they began. Those that threw are not among them.
    [[nodiscard]] std::vector<Note> notes() const;

    /// Forgets the notes, whose numbers mean nothing any more. The trace stays.
    void clearNotes();

private:
    /// One worker's own; on cache lines of its own.
    struct alignas(64) Worker
    {
        std::vector<Note> notes;
        std::size_t absorbed = 0;
    };

    bool run(validity::CheckId check, unsigned worker);

    OmplChecker& checker_;
    std::shared_ptr<CheckTrace> trace_;
    bool replays_;
    double lastSeconds_ = 0.0;
    std::vector<Worker> workers_;
};
}  // namespace specplan::planner
