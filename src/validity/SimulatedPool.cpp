// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/SimulatedPool.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "specplan/validity/RunCheck.h"
#include "specplan/validity/TakeUnwanted.h"

namespace specplan::validity
{
class SimulatedPool::Call
{
public:
    explicit Call(SimulatedPool& pool) : pool_(pool)
    {
        pool.advanceTo(pool.now());
    }

    ~Call()
    {
        pool_.seen_ = pool_.timing_.ofSearch();
    }

    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

private:
    SimulatedPool& pool_;
};

SimulatedPool::SimulatedPool(Checker& checker, unsigned workers, Timing timing)
    : checker_(checker),
      workers_(std::max(workers, 1U)),
      timing_(std::move(timing)),
      seen_(timing_.ofSearch()),
      idle_(threads(), -std::numeric_limits<double>::infinity())
{
}

double SimulatedPool::now() const noexcept
{
    return now_ + std::max(timing_.ofSearch() - seen_, 0.0);
}

Completion SimulatedPool::runHere(CheckId check)
{
    const Call call(*this);
    return runInSearchThread(check);
}

unsigned SimulatedPool::freeWorkers() const noexcept
{
    return inHand() < workers_ ? workers_ - static_cast<unsigned>(inHand()) : 0;
}

unsigned SimulatedPool::room() const noexcept
{
    if (runsInline())
        return 0;
    CountByKind queued{};
    for (const auto* queue : {&demanded_, &speculative_})
        for (const CheckId check : *queue)
            ++queued[kindOf(check)];
    return supply_.room(workers_, searchThreadWorks(), inHand(), queued);
}

bool SimulatedPool::runsDry()
{
    const Call call(*this);
    return demanded_.empty() && speculative_.empty() && started_ > 0 && (inHand() == 0 || !finished_.empty());
}

void SimulatedPool::submit(CheckId check, Urgency urgency)
{
    const Call call(*this);
    advanceTo(now_ + timing_.handOver);
    (urgency == Urgency::Demanded ? demanded_ : speculative_).push_back(check);
    if (idle_.empty() || stop_.askNowAndThen())
        return;
    const bool sleeps = now_ - idle_.back() > PoolRules::kWorkerSpins;
    idle_.pop_back();
    begin(now_ + (sleeps ? timing_.wake : 0.0));
}

void SimulatedPool::promote(CheckId check)
{
    const Call call(*this);
    const auto place = std::ranges::find(speculative_, check);
    if (place == speculative_.end())
        return;
    speculative_.erase(place);
    demanded_.push_back(check);
}

void SimulatedPool::collect(std::vector<Completion>& out, std::chrono::milliseconds patience)
{
    if (inHand() == 0)
        return;
    const Call call(*this);
    if (finished_.empty() && patience.count() > 0)
    {
        if (searchThreadWorks() && !(demanded_.empty() && speculative_.empty()) && !stop_.askNowAndThen())
            out.push_back(runInSearchThread(popQueue()));
        else if (!running_.empty())
            waitForResult();
    }
    std::ranges::move(finished_, std::back_inserter(out));
    finished_.clear();
}

void SimulatedPool::cancelQueued(std::vector<CheckId>& dropped)
{
    const Call call(*this);
    dropped.insert(dropped.end(), demanded_.begin(), demanded_.end());
    dropped.insert(dropped.end(), speculative_.begin(), speculative_.end());
    demanded_.clear();
    speculative_.clear();
}

void SimulatedPool::cancelUnwanted(const std::function<bool(CheckId)>& isWanted, std::vector<CheckId>& dropped)
{
    const Call call(*this);
    takeUnwanted(speculative_, isWanted, dropped);
}

/// A search thread that waits for long goes to sleep.
void SimulatedPool::waitForResult()
{
    const double end = running_.front().end;
    advanceTo(end - now_ > PoolRules::kSearchSpins ? end + timing_.wake : end);
}

/// What the workers do until then.
void SimulatedPool::advanceTo(double time)
{
    while (!running_.empty() && running_.front().end <= time)
    {
        std::ranges::pop_heap(running_, &Running::after);
        const double end = running_.back().end;
        finished_.push_back(std::move(running_.back().completion));
        running_.pop_back();
        if ((demanded_.empty() && speculative_.empty()) || stop_.askNowAndThen())
            idle_.push_back(end);
        else
            begin(end);
    }
    now_ = std::max(now_, time);
}

/// A worker takes the next check.
void SimulatedPool::begin(double time)
{
    Completion completion = run(popQueue());
    const double end = time + completion.seconds;
    running_.push_back({end, started_++, std::move(completion)});
    std::ranges::push_heap(running_, &Running::after);
}

Completion SimulatedPool::run(CheckId check)
{
    Completion completion = runCheck(checker_, check, 0);
    completion.seconds = std::max(timing_.ofCheck(check, completion.valid), 0.0);
    supply_.learn(check, completion.seconds);
    return completion;
}

Completion SimulatedPool::runInSearchThread(CheckId check)
{
    Completion completion = run(check);
    completion.here = true;
    advanceTo(now_ + completion.seconds + timing_.afterCheck);
    return completion;
}

CheckId SimulatedPool::popQueue()
{
    std::deque<CheckId>& queue = demanded_.empty() ? speculative_ : demanded_;
    const CheckId check = queue.front();
    queue.pop_front();
    return check;
}
}  // namespace specplan::validity
