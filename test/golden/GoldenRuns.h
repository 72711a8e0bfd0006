// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/PlannerSettings.h"

namespace specplan::test
{
/// One search on the virtual clock, whose numbers are the same on every machine.
struct GoldenRun
{
    std::string name;  ///< no blanks
    std::function<std::shared_ptr<ompl::geometric::SimpleSetup>()> make;
    PlannerSettings settings;
};

/// Grid maps, every kind of state space, arms and rigid bodies; both evaluations, all policies, 1 to 128 workers.
/// \param scenes folder of the scenes that come with the project.
[[nodiscard]] std::vector<GoldenRun> goldenRuns(const std::string& scenes);

/// What the search did, in one line: name, status, hash of the order of expansions, expansions, checks used, run and
/// run ahead, cost, seconds on the virtual clock.
[[nodiscard]] std::string resultOf(const GoldenRun& run);
}  // namespace specplan::test
