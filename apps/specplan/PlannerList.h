// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "specplan/problems/OmplAppProblem.h"

namespace specplan::command
{
/// Reads "NAME" or "NAME:key=value;key=value". In results the planner is called what was written, with blanks for
/// semicolons, unless a "name" is given. \throws InputError.
[[nodiscard]] problems::PlannerRequest parsePlanner(const std::string& text);

/// Reads several, separated by commas; a comma before a digit belongs to a value ("spacing=1,1,0.2").
/// \throws InputError, also where two would have one name in results.
[[nodiscard]] std::vector<problems::PlannerRequest> parsePlanners(const std::string& text);
}  // namespace specplan::command
