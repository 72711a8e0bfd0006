// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "specplan/validity/Executor.h"
#include "specplan/validity/PoolRules.h"
#include "specplan/validity/Supply.h"

namespace specplan::validity
{
/// What a ThreadPoolExecutor would do on a machine with a processor for each worker: the same rules, on a clock that
/// knows how long checks, the search's own work and handing over take. One worker is an InlineExecutor.
///
/// VirtualExecutor asks what speculation is worth in itself; this one predicts what a real run will take. A check runs
/// for real in the calling thread when a simulated worker takes it, and counts as finished when the clock has advanced
/// by its duration. While the search works the clock advances by what that takes, and the workers go on.
///
/// Threads: search thread only.
class SimulatedPool : public Executor
{
public:
    /// How long things take, in seconds.
    struct Timing
    {
        /// Of the check that has just been run; at least 0.
        std::function<double(CheckId check, bool valid)> ofCheck;

        /// Of the search's own work since some moment in the past; what happens inside of the executor is left out.
        std::function<double()> ofSearch;

        /// Of the search thread, for handing a check to another thread and taking it back.
        double handOver = 0.5e-6;

        /// Of the search thread, for finding its way back into its own work after a check that it has run itself.
        double afterCheck = 0.0;

        /// Until a thread that sleeps goes on.
        double wake = 15e-6;
    };

    /// \param checker must outlive the executor; it is always called with worker number 0.
    SimulatedPool(Checker& checker, unsigned workers, Timing timing);

    [[nodiscard]] unsigned workers() const noexcept override
    {
        return workers_;
    }

    [[nodiscard]] bool runsInline() const noexcept override
    {
        return workers_ == 1;
    }

    [[nodiscard]] bool canRunHere() const noexcept override
    {
        return worksHere() || inHand() == 0;
    }

    [[nodiscard]] bool worksHere() const noexcept override
    {
        return runsInline() || searchThreadWorks();
    }

    [[nodiscard]] Completion runHere(CheckId check) override;
    [[nodiscard]] unsigned freeWorkers() const noexcept override;
    [[nodiscard]] unsigned room() const noexcept override;
    [[nodiscard]] bool runsDry() override;

    [[nodiscard]] bool busy() const noexcept override
    {
        return inHand() > 0;
    }

    void searchThought(double seconds) override
    {
        supply_.learnThought(seconds);
    }

    void submit(CheckId check, Urgency urgency) override;
    void promote(CheckId check) override;
    void collect(std::vector<Completion>& out, std::chrono::milliseconds patience) override;
    void cancelQueued(std::vector<CheckId>& dropped) override;
    void cancelUnwanted(const std::function<bool(CheckId)>& isWanted, std::vector<CheckId>& dropped) override;
    [[nodiscard]] double now() const noexcept override;

private:
    struct Running
    {
        double end;
        std::uint64_t order;  ///< of starting; ties finish in this order
        Completion completion;

        [[nodiscard]] bool after(const Running& other) const noexcept
        {
            return end != other.end ? end > other.end : order > other.order;
        }
    };

    /// One call of the executor: lets the clock catch up with the search's work before it, and leaves the call itself
    /// out of what the search has done.
    class Call;

    [[nodiscard]] bool searchThreadWorks() const noexcept
    {
        return PoolRules::searchThreadWorks(workers_);
    }

    /// Workers with a thread of their own.
    [[nodiscard]] unsigned threads() const noexcept
    {
        return workers_ - (searchThreadWorks() ? 1 : 0);
    }

    [[nodiscard]] std::size_t inHand() const noexcept
    {
        return running_.size() + demanded_.size() + speculative_.size() + finished_.size();
    }

    void waitForResult();
    void advanceTo(double time);
    void begin(double time);
    [[nodiscard]] Completion run(CheckId check);
    [[nodiscard]] Completion runInSearchThread(CheckId check);
    [[nodiscard]] CheckId popQueue();

    Checker& checker_;
    unsigned workers_;
    Timing timing_;
    double now_ = 0.0;   ///< of the search thread, at its last call
    double seen_ = 0.0;  ///< the search's work up to there
    std::uint64_t started_ = 0;
    Supply supply_;
    std::vector<Running> running_;  ///< heap, first to finish on top
    std::vector<double> idle_;      ///< since when, of the threads that have nothing to do; the latest one last
    std::deque<CheckId> demanded_;
    std::deque<CheckId> speculative_;
    std::vector<Completion> finished_;
};
}  // namespace specplan::validity
