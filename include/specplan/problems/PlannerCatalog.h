// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>

namespace specplan::problems
{
/// Names of the planners that `makePlanner` knows: OMPL's geometric ones by class, and SpeculativeAStar.
[[nodiscard]] std::vector<std::string> plannerNames();

/// Whether there is such a planner; case does not matter, and OMPL.app's names ("kpiece", "aps") are known too.
[[nodiscard]] bool isPlannerName(const std::string& name);

/// Makes a planner. \param parameters by OMPL's names; "name" is what to call it.
/// \throws InputError naming the planner or parameter.
[[nodiscard]] ompl::base::PlannerPtr makePlanner(const std::string& name,
                                                 const std::map<std::string, std::string>& parameters,
                                                 const ompl::base::SpaceInformationPtr& si);
}  // namespace specplan::problems
