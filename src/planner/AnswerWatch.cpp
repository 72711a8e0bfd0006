// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerWatch.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace specplan::planner
{
AnswerWatch::AnswerWatch(unsigned workers, double patience, std::function<void(std::size_t)> warn)
    : patience_(patience), warn_(std::move(warn)), running_(workers), thread_([this] { watch(); })
{
}

AnswerWatch::~AnswerWatch()
{
    {
        const std::lock_guard lock(mutex_);
        isOver_ = true;
    }
    over_.notify_one();
    thread_.join();
}

void AnswerWatch::watch()
{
    std::unique_lock lock(mutex_);
    for (std::uint64_t seen = answers_;; seen = answers_)
    {
        if (over_.wait_for(lock, std::chrono::duration<double>(patience_), [this] { return isOver_; }))
            return;
        const auto stuck = std::ranges::find_if(running_, [](const auto& state) { return state != 0; });
        if (answers_ != seen || stuck == running_.end())
            continue;
        warn_(*stuck - 1);
        return;
    }
}
}  // namespace specplan::planner
