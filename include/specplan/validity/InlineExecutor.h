// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/validity/Executor.h"

namespace specplan::validity
{
/// Runs each check in the calling thread: sequential A*. No thread, no lock.
///
/// Reading the clock costs as much as a cheap check: of checks below a microsecond every 16th is measured and stands
/// for the others.
class InlineExecutor : public Executor
{
public:
    /// \param checker must outlive the executor.
    explicit InlineExecutor(Checker& checker) : checker_(checker)
    {
    }

    [[nodiscard]] unsigned workers() const noexcept override
    {
        return 1;
    }

    [[nodiscard]] bool runsInline() const noexcept override
    {
        return true;
    }

    [[nodiscard]] unsigned freeWorkers() const noexcept override
    {
        return 1;
    }

    [[nodiscard]] bool busy() const noexcept override
    {
        return !finished_.empty();
    }

    void submit(CheckId check, Urgency urgency) override;

    void promote(CheckId) override
    {
    }

    void collect(std::vector<Completion>& out, std::chrono::milliseconds patience) override;

    void cancelQueued(std::vector<CheckId>&) override
    {
    }

    [[nodiscard]] double now() const noexcept override;

private:
    Checker& checker_;
    std::vector<Completion> finished_;
    double lastSeconds_ = 1.0;  ///< duration of the last check that was measured
    unsigned unmeasured_ = 0;   ///< checks since then
};
}  // namespace specplan::validity
