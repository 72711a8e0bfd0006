// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "specplan/validity/Executor.h"

namespace specplan::validity
{
/// N workers on a virtual clock: every verdict is real, time is simulated.
///
/// A check runs for real in the calling thread when a virtual worker takes it, and counts as finished once the virtual
/// clock has advanced by its cost. The clock advances only when the search waits, so the search itself takes no time.
/// With a deterministic cost two runs are the same, event for event.
class VirtualExecutor : public Executor
{
public:
    /// Cost of a check in seconds of virtual time, at least 0; is told the verdict.
    using Cost = std::function<double(CheckId check, bool valid)>;

    /// \param checker must outlive the executor; it is always called with worker number 0.
    VirtualExecutor(Checker& checker, unsigned workers, Cost cost);

    [[nodiscard]] unsigned workers() const noexcept override
    {
        return workers_;
    }

    [[nodiscard]] bool runsInline() const noexcept override
    {
        return false;
    }

    /// Its worker would be one too many.
    [[nodiscard]] bool canRunHere() const noexcept override
    {
        return false;
    }

    [[nodiscard]] bool worksHere() const noexcept override
    {
        return false;
    }

    /// \throws std::logic_error: see canRunHere.
    [[nodiscard]] Completion runHere(CheckId check) override;

    [[nodiscard]] unsigned freeWorkers() const noexcept override;

    [[nodiscard]] unsigned room() const noexcept override
    {
        return freeWorkers();
    }

    /// Time stands still while the search works.
    [[nodiscard]] bool runsDry() override
    {
        return false;
    }

    [[nodiscard]] bool busy() const noexcept override;
    void submit(CheckId check, Urgency urgency) override;
    void promote(CheckId check) override;
    void collect(std::vector<Completion>& out, std::chrono::milliseconds patience) override;
    void cancelQueued(std::vector<CheckId>& dropped) override;
    void cancelUnwanted(const std::function<bool(CheckId)>& isWanted, std::vector<CheckId>& dropped) override;

    [[nodiscard]] double now() const noexcept override
    {
        return now_;
    }

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

    void start(CheckId check);
    void startQueued();

    Checker& checker_;
    unsigned workers_;
    Cost cost_;
    double now_ = 0.0;
    std::uint64_t started_ = 0;
    std::vector<Running> running_;  ///< heap, first to finish on top
    std::deque<CheckId> demanded_;
    std::deque<CheckId> speculative_;
};
}  // namespace specplan::validity
