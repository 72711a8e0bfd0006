// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "specplan/validity/Executor.h"

namespace specplan::validity
{
/// A persistent pool of worker threads. Threads start on first use, sleep when there is nothing to do, and end with the
/// executor.
///
/// Threads: the search thread owns the executor; workers share only what `mutex_` guards. A worker never touches
/// verdicts, the lattice's growing parts or statistics: it runs the check and leaves a Completion.
class ThreadPoolExecutor : public Executor
{
public:
    /// \param checker must outlive the executor. \param workers at least 1.
    ThreadPoolExecutor(Checker& checker, unsigned workers);
    ~ThreadPoolExecutor() override;
    ThreadPoolExecutor(const ThreadPoolExecutor&) = delete;
    ThreadPoolExecutor& operator=(const ThreadPoolExecutor&) = delete;

    [[nodiscard]] unsigned workers() const noexcept override
    {
        return workers_;
    }

    [[nodiscard]] bool runsInline() const noexcept override
    {
        return false;
    }

    [[nodiscard]] unsigned freeWorkers() const noexcept override
    {
        return inHand_ < workers_ ? workers_ - static_cast<unsigned>(inHand_) : 0;
    }

    [[nodiscard]] bool busy() const noexcept override
    {
        return inHand_ > 0;
    }

    void submit(CheckId check, Urgency urgency) override;
    void promote(CheckId check) override;
    void collect(std::vector<Completion>& out, std::chrono::milliseconds patience) override;
    void cancelQueued(std::vector<CheckId>& dropped) override;
    [[nodiscard]] double now() const noexcept override;

private:
    void startThreadFor(std::size_t inHand);
    void work(unsigned worker);

    Checker& checker_;
    const unsigned workers_;

    // Search thread only.
    std::size_t inHand_ = 0;  ///< submitted and not collected
    std::vector<std::thread> threads_;

    // Guarded by mutex_.
    std::mutex mutex_;
    std::condition_variable workAvailable_;
    std::condition_variable resultAvailable_;
    std::deque<CheckId> demanded_;
    std::deque<CheckId> speculative_;
    std::vector<Completion> finished_;
    bool searchWaits_ = false;
    bool ending_ = false;
};
}  // namespace specplan::validity
