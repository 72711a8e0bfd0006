// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/problems/GridSetup.h"
#include "specplan/problems/MovingAi.h"

namespace specplan::test
{
/// Length of the path that the planner finds for an entry.
inline double plannedLength(const problems::GridMap& map, const problems::ScenarioEntry& entry)
{
    const auto setup =
        problems::makeGridSetup({map, entry.start, entry.goal}, entry.map, problems::GridCost::Length, {});
    PlannerSettings settings = problems::gridPlannerSettings(false);
    settings.numThreads = 1;
    const auto planner = std::make_shared<SpeculativeAStar>(setup->getSpaceInformation(), settings);
    planner->setProblemDefinition(setup->getProblemDefinition());
    setup->getSpaceInformation()->setup();
    planner->setup();
    planner->solve(ompl::base::plannerNonTerminatingCondition());
    return planner->getReport().cost;
}
}  // namespace specplan::test
