// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include <ompl/base/GenericParam.h>

#include "specplan/planner/PlannerSettings.h"

namespace specplan::planner
{
/// Checks every setting against its range.
/// \throws std::invalid_argument with one line that names the parameter, what was expected and what was given.
void validate(const PlannerSettings& settings);

/// Declares one OMPL parameter for each setting. Values are parsed strictly: what is not a number, or out of range, is
/// refused and the old value stays (OMPL's own conversion reads "-1" as 4294967295, "7.9" as 7 and "no" as true).
/// \param get, set how to reach the settings; `set` may throw std::invalid_argument.
void declareParameters(ompl::base::ParamSet& params, std::function<PlannerSettings()> get,
                       std::function<void(const PlannerSettings&)> set);
}  // namespace specplan::planner
