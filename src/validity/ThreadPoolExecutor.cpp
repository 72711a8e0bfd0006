// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/ThreadPoolExecutor.h"

#include <algorithm>
#include <iterator>
#include <system_error>

#include "specplan/validity/RunCheck.h"

namespace specplan::validity
{
ThreadPoolExecutor::ThreadPoolExecutor(Checker& checker, unsigned workers)
    : checker_(checker), workers_(std::max(workers, 1U))
{
    threads_.reserve(workers_);
}

ThreadPoolExecutor::~ThreadPoolExecutor()
{
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        demanded_.clear();
        speculative_.clear();
    }
    workAvailable_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void ThreadPoolExecutor::submit(CheckId check, Urgency urgency)
{
    startThreadFor(inHand_ + 1);
    {
        const std::lock_guard lock(mutex_);
        (urgency == Urgency::Demanded ? demanded_ : speculative_).push_back(check);
    }
    ++inHand_;
    workAvailable_.notify_one();
}

void ThreadPoolExecutor::startThreadFor(std::size_t inHand)
{
    if (threads_.size() >= std::min<std::size_t>(inHand, workers_))
        return;
    try
    {
        threads_.emplace_back(&ThreadPoolExecutor::work, this, static_cast<unsigned>(threads_.size()));
    }
    catch (const std::system_error&)
    {
        // The system gives no more threads: the ones there are do the work, only none at all is an error.
        if (threads_.empty())
            throw;
    }
}

void ThreadPoolExecutor::promote(CheckId check)
{
    const std::lock_guard lock(mutex_);
    const auto place = std::ranges::find(speculative_, check);
    if (place == speculative_.end())
        return;
    speculative_.erase(place);
    demanded_.push_back(check);
}

void ThreadPoolExecutor::collect(std::vector<Completion>& out, std::chrono::milliseconds patience)
{
    if (inHand_ == 0)
        return;
    const std::size_t before = out.size();
    {
        std::unique_lock lock(mutex_);
        if (finished_.empty() && patience.count() > 0)
        {
            searchWaits_ = true;
            resultAvailable_.wait_for(lock, patience, [this] { return !finished_.empty(); });
            searchWaits_ = false;
        }
        std::ranges::move(finished_, std::back_inserter(out));
        finished_.clear();
    }
    inHand_ -= out.size() - before;
}

void ThreadPoolExecutor::cancelQueued(std::vector<CheckId>& dropped)
{
    const std::size_t before = dropped.size();
    {
        const std::lock_guard lock(mutex_);
        dropped.insert(dropped.end(), demanded_.begin(), demanded_.end());
        dropped.insert(dropped.end(), speculative_.begin(), speculative_.end());
        demanded_.clear();
        speculative_.clear();
    }
    inHand_ -= dropped.size() - before;
}

double ThreadPoolExecutor::now() const noexcept
{
    return steadySeconds();
}

void ThreadPoolExecutor::work(unsigned worker)
{
    std::unique_lock lock(mutex_);
    for (;;)
    {
        workAvailable_.wait(lock, [this] { return ending_ || !demanded_.empty() || !speculative_.empty(); });
        if (ending_)
            return;
        std::deque<CheckId>& queue = demanded_.empty() ? speculative_ : demanded_;
        const CheckId check = queue.front();
        queue.pop_front();

        lock.unlock();
        Completion completion = runCheck(checker_, check, worker);
        lock.lock();

        finished_.push_back(std::move(completion));
        if (searchWaits_)
            resultAvailable_.notify_one();
    }
}
}  // namespace specplan::validity
