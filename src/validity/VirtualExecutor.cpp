// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/VirtualExecutor.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "specplan/validity/RunCheck.h"
#include "specplan/validity/TakeUnwanted.h"

namespace specplan::validity
{
VirtualExecutor::VirtualExecutor(Checker& checker, unsigned workers, Cost cost)
    : checker_(checker), workers_(std::max(workers, 1U)), cost_(std::move(cost))
{
}

Completion VirtualExecutor::runHere(CheckId)
{
    throw std::logic_error("a virtual executor has no worker in the calling thread");
}

unsigned VirtualExecutor::freeWorkers() const noexcept
{
    const std::size_t taken = running_.size() + demanded_.size() + speculative_.size();
    return taken < workers_ ? workers_ - static_cast<unsigned>(taken) : 0;
}

bool VirtualExecutor::busy() const noexcept
{
    return !running_.empty();
}

void VirtualExecutor::submit(CheckId check, Urgency urgency)
{
    (urgency == Urgency::Demanded ? demanded_ : speculative_).push_back(check);
    startQueued();
}

void VirtualExecutor::promote(CheckId check)
{
    const auto place = std::ranges::find(speculative_, check);
    if (place == speculative_.end())
        return;
    speculative_.erase(place);
    demanded_.push_back(check);
}

void VirtualExecutor::collect(std::vector<Completion>& out, std::chrono::milliseconds patience)
{
    if (running_.empty())
        return;
    if (running_.front().end > now_)
    {
        if (patience.count() == 0)
            return;
        now_ = running_.front().end;
    }
    while (!running_.empty() && running_.front().end <= now_)
    {
        std::ranges::pop_heap(running_, &Running::after);
        out.push_back(std::move(running_.back().completion));
        running_.pop_back();
    }
    startQueued();
}

void VirtualExecutor::cancelQueued(std::vector<CheckId>& dropped)
{
    dropped.insert(dropped.end(), demanded_.begin(), demanded_.end());
    dropped.insert(dropped.end(), speculative_.begin(), speculative_.end());
    demanded_.clear();
    speculative_.clear();
}

void VirtualExecutor::cancelUnwanted(const std::function<bool(CheckId)>& isWanted, std::vector<CheckId>& dropped)
{
    takeUnwanted(speculative_, isWanted, dropped);
}

void VirtualExecutor::startQueued()
{
    for (std::deque<CheckId>* queue : {&demanded_, &speculative_})
        while (running_.size() < workers_ && !queue->empty() && !stop_.askNowAndThen())
        {
            const CheckId check = queue->front();
            queue->pop_front();
            start(check);
        }
}

void VirtualExecutor::start(CheckId check)
{
    Completion completion = runCheck(checker_, check, 0);
    completion.seconds = std::max(cost_(check, completion.valid), 0.0);
    const double end = now_ + completion.seconds;
    running_.push_back({end, started_++, std::move(completion)});
    std::ranges::push_heap(running_, &Running::after);
}
}  // namespace specplan::validity
