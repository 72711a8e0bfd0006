// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "Run.h"

namespace specplan::command
{
/// Tells how long a search takes with more threads, each on a processor of its own, from one run with one thread.
/// \param recorded that run. \param trace what its checks found and how long they took; checks that it lacks, which a
/// search with more threads runs ahead and does not need, are run and added.
/// \return a run for each of `options.predict`, whose times are predicted and whose speed-up is that over the recorded
/// one; none, with a line on standard error, if the recorded one did not come to its end.
/// \throws std::logic_error if the order of expansions differs.
[[nodiscard]] std::vector<Run> predict(const Problem& problem, const PlanOptions& options, const Run& recorded,
                                       const std::shared_ptr<planner::CheckTrace>& trace);
}  // namespace specplan::command
