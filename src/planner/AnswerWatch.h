// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace specplan::planner
{
/// Notices when no check comes back any more.
///
/// Threads: each worker reports its own checks; the watch has a thread of its own.
class AnswerWatch
{
public:
    /// \param patience seconds without an answer. \param warn told the state of a check that does not come back, in
    /// the watch's thread, once.
    AnswerWatch(unsigned workers, double patience, std::function<void(std::size_t state)> warn);
    ~AnswerWatch();

    AnswerWatch(const AnswerWatch&) = delete;
    AnswerWatch& operator=(const AnswerWatch&) = delete;

    void begins(unsigned worker, std::size_t state) noexcept
    {
        running_[worker] = state + 1;
    }

    void ends(unsigned worker) noexcept
    {
        running_[worker] = 0;
        ++answers_;
    }

private:
    void watch();

    double patience_;
    std::function<void(std::size_t)> warn_;
    std::vector<std::atomic<std::size_t>> running_;  ///< state + 1, or 0 for none
    std::atomic<std::uint64_t> answers_{0};
    std::mutex mutex_;
    std::condition_variable over_;
    bool isOver_ = false;
    std::thread thread_;
};
}  // namespace specplan::planner
