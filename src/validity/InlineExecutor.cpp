// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/InlineExecutor.h"

#include <iterator>

namespace specplan::validity
{
void InlineExecutor::submit(CheckId check, Urgency)
{
    finished_.push_back(runHere(check));
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
