// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/validity/InlineRunner.h"

namespace specplan::validity
{
/// Runs each check in the calling thread: sequential A*. No thread, no lock.
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

    [[nodiscard]] bool canRunHere() const noexcept override
    {
        return true;
    }

    [[nodiscard]] bool worksHere() const noexcept override
    {
        return true;
    }

    [[nodiscard]] Completion runHere(CheckId check) override
    {
        return runner_.run(checker_, check, 0);
    }

    [[nodiscard]] unsigned freeWorkers() const noexcept override
    {
        return 1;
    }

    [[nodiscard]] unsigned room() const noexcept override
    {
        return 0;
    }

    [[nodiscard]] bool runsDry() override
    {
        return false;
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

    void cancelUnwanted(const std::function<bool(CheckId)>&, std::vector<CheckId>&) override
    {
    }

    [[nodiscard]] double now() const noexcept override;

private:
    Checker& checker_;
    InlineRunner runner_;
    std::vector<Completion> finished_;
};
}  // namespace specplan::validity
