// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/InlineExecutor.h"

#include <iterator>

#include "specplan/validity/RunCheck.h"

namespace specplan::validity
{
namespace
{
constexpr double kCheapSeconds = 1e-6;
constexpr unsigned kSampleEvery = 16;
}  // namespace

void InlineExecutor::submit(CheckId check, Urgency)
{
    if (lastSeconds_ < kCheapSeconds && ++unmeasured_ < kSampleEvery)
    {
        finished_.push_back(runCheckUnmeasured(checker_, check, 0));
        finished_.back().seconds = lastSeconds_;
        return;
    }
    finished_.push_back(runCheck(checker_, check, 0));
    lastSeconds_ = finished_.back().seconds;
    unmeasured_ = 0;
}

void InlineExecutor::collect(std::vector<Completion>& out, std::chrono::milliseconds)
{
    out.insert(out.end(), std::make_move_iterator(finished_.begin()), std::make_move_iterator(finished_.end()));
    finished_.clear();
}

double InlineExecutor::now() const noexcept
{
    return steadySeconds();
}
}  // namespace specplan::validity
