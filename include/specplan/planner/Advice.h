// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/SearchReport.h"

namespace specplan::planner
{
/// One search in words: "spacing x 2, weight 3: no path, 340 states expanded of about 900, 512 checks".
[[nodiscard]] std::string describe(const LatticeSearchReport& search);

/// What to try next after a query that has found no path. \param canBeLazy whether lazy evaluation would be possible.
/// \param processors that may be used.
[[nodiscard]] std::string advise(const SearchReport& report, const PlannerSettings& settings, bool canBeLazy,
                                 unsigned processors);
}  // namespace specplan::planner
