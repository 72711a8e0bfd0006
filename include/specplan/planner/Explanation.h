// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <ostream>
#include <string>

#include "specplan/planner/PlannerSession.h"
#include "specplan/planner/SearchReport.h"

namespace specplan::planner
{
/// Writes what solve() would do with the query that was just opened. \param refusal why it would not; empty if it
/// would.
void explain(const PlannerSession& session, const std::string& refusal, std::ostream& out);

/// Enters the numbers of a run under names that OMPL's Benchmark logs as columns.
void describeRun(const SearchReport& report, std::map<std::string, std::string>& properties);
}  // namespace specplan::planner
