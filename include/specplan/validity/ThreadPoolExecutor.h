// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "specplan/validity/BudgetShare.h"
#include "specplan/validity/InlineRunner.h"
#include "specplan/validity/MajorityVote.h"
#include "specplan/validity/PoolRules.h"
#include "specplan/validity/Supply.h"

namespace specplan::validity
{
/// A persistent pool of worker threads. Threads start ahead of time or on first use, spin for a moment when they run
/// out of work, then sleep, and end with the executor.
///
/// With few workers the search thread is one of them: instead of waiting it runs checks from the queue. With many it
/// only hands out and collects, since in the time of one check so much comes back that the others would run dry; and so
/// it does where checks are long, since it has to ask whether to stop.
///
/// Who runs a check holds a worker's number meanwhile: a thread its own, but the last number is the search thread's as
/// long as that is a worker.
///
/// A pool may share a budget of threads with others. It then has the search thread, or one of its own in the place of
/// that, and borrows each further one for the time of a check.
///
/// Threads: the search thread owns the executor; workers share only what `mutex_` guards, and the atomic counters that
/// tell when it is worth taking. A worker never touches verdicts, the lattice's growing parts or statistics: it runs
/// the check and leaves a Completion.
class ThreadPoolExecutor : public Executor
{
public:
    /// \param checker must outlive the executor. \param workers at least 1. \param share of a budget of threads, which
    /// the search thread has entered while checks are in hand; empty for none.
    ThreadPoolExecutor(Checker& checker, unsigned workers, std::shared_ptr<BudgetShare> share = nullptr);
    ~ThreadPoolExecutor() override;
    ThreadPoolExecutor(const ThreadPoolExecutor&) = delete;
    ThreadPoolExecutor& operator=(const ThreadPoolExecutor&) = delete;

    /// Starts as many threads as there are processors for, which takes some 50 µs each: time that the first search will
    /// not have to spend.
    void startThreads();

    [[nodiscard]] unsigned workers() const noexcept override
    {
        return workers_;
    }

    [[nodiscard]] bool runsInline() const noexcept override
    {
        return false;
    }

    [[nodiscard]] bool canRunHere() const noexcept override
    {
        return worksHere() || inHand_ == 0;
    }

    [[nodiscard]] bool worksHere() const noexcept override;

    [[nodiscard]] Completion runHere(CheckId check) override;
    [[nodiscard]] unsigned freeWorkers() const noexcept override
    {
        return inHand_ < usedWorkers() ? usedWorkers() - static_cast<unsigned>(inHand_) : 0;
    }

    [[nodiscard]] unsigned room() const noexcept override;
    [[nodiscard]] bool runsDry() override;

    [[nodiscard]] bool busy() const noexcept override
    {
        return inHand_ > 0;
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
    using Lock = std::unique_lock<std::mutex>;

    /// Workers that may run now.
    [[nodiscard]] unsigned usedWorkers() const noexcept
    {
        return std::min(mayUse_, busyChecks_.yes() ? std::min(workers_, processors_) : workers_);
    }

    /// Whether the search thread should be a worker, and will be once its number is free.
    [[nodiscard]] bool searchThreadShouldWork() const noexcept
    {
        return PoolRules::searchThreadWorks(usedWorkers()) && !longChecks_;
    }

    [[nodiscard]] unsigned threadsToRun() const noexcept
    {
        return usedWorkers() - (searchThreadShouldWork() ? 1 : 0);
    }

    void startThreadFor(std::size_t inHand);
    void take(std::vector<Completion>& out);
    [[nodiscard]] bool workInstead(Lock& lock, std::vector<Completion>& out);
    void waitForResult(Lock& lock, std::chrono::milliseconds patience);
    void learn(const Completion& completion);
    void noteHandedBack(std::size_t count);
    void adaptThreads();
    void adaptToBudget();
    [[nodiscard]] bool needsToBorrow() const noexcept;
    [[nodiscard]] bool borrow(Lock& lock);
    [[nodiscard]] Completion runAsWorker(Lock& lock, InlineRunner& runner, unsigned worker);
    [[nodiscard]] unsigned takeNumber(unsigned worker);
    void giveNumberBack(unsigned number);
    [[nodiscard]] bool hasWork() const;
    [[nodiscard]] CheckId popQueue();
    [[nodiscard]] std::size_t queued() const noexcept
    {
        return queued_[0].load(std::memory_order_relaxed) + queued_[1].load(std::memory_order_relaxed);
    }
    void work(unsigned worker);
    void waitForWork(Lock& lock, bool mayBeSoon);
    [[nodiscard]] bool keepsSearchOff() const noexcept;

    Checker& checker_;
    const unsigned workers_;
    const unsigned processors_;
    const std::shared_ptr<BudgetShare> share_;

    // Search thread only.
    std::size_t inHand_ = 0;   ///< submitted and not collected
    Supply supply_;            ///< of checks in the queue
    unsigned mayUse_;          ///< workers, the budget being what it is
    MajorityVote busyChecks_;  ///< whether checks keep a processor busy
    bool longChecks_ = false;  ///< whether they keep the search thread from asking whether to stop
    InlineRunner runner_;
    std::vector<std::thread> threads_;

    // Written under mutex_; read without it as hints.
    std::array<std::atomic<std::size_t>, 2> queued_{};  ///< states, motions
    std::atomic<std::size_t> done_{0};
    std::atomic<unsigned> threadLimit_;  ///< pool threads that may run a check now
    std::atomic<bool> ending_{false};
    std::atomic<bool> lastNumberTaken_{false};  ///< by a pool thread
    std::atomic<bool> lastIsReserved_{false};   ///< the last number is for the search thread
    std::atomic<bool> ownTaken_{false};  ///< a pool thread runs instead of the search thread, in the budget's eyes

    std::atomic<int> searchProcessor_{-1};  ///< where the search thread last ran, as it says: a hint

    // Guarded by mutex_.
    std::mutex mutex_;
    std::condition_variable workAvailable_;
    std::condition_variable resultAvailable_;
    std::deque<CheckId> demanded_;
    std::deque<CheckId> speculative_;
    std::vector<Completion> finished_;
    std::vector<bool> numberTaken_;  ///< by pool threads
    unsigned running_ = 0;           ///< pool threads that run a check
    unsigned sleepers_ = 0;          ///< pool threads that have to be woken and are not being woken: that may take long
    bool searchWaits_ = false;       ///< the same of the search thread
};
}  // namespace specplan::validity
