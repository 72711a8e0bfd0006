// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>

#include "Options.h"
#include "ProblemFile.h"
#include "specplan/planner/SearchReport.h"
#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::command
{
/// One finished search.
struct Run
{
    std::string problem;
    PlannerSettings settings;
    SearchReport report;
    std::shared_ptr<SpeculativeAStar> planner;            ///< empty once results are all that is wanted
    std::shared_ptr<ompl::geometric::SimpleSetup> setup;  ///< likewise
    std::vector<problems::GridCell> expanded;             ///< in order, if asked for
    std::vector<problems::GridCell> path;                 ///< empty if there is none

    /// Seconds from start to end on the clock of the executor.
    [[nodiscard]] double seconds() const
    {
        return settings.executor == "virtual" ? report.virtualTime : report.wallTime;
    }

    [[nodiscard]] bool solved() const
    {
        return report.status == "solved";
    }
};

/// Plans once. The search stops early at the time limit, or when the user interrupts the program.
/// \param keepOrder whether to note the expanded cells.
[[nodiscard]] Run planOnce(const NamedProblem& problem, const CommonOptions& options, const PlannerSettings& settings,
                           bool keepOrder);

/// From now on Ctrl-C stops the search and leaves what has been found; a second one ends the program.
void stopOnInterrupt();

/// Whether the user has asked to stop.
[[nodiscard]] bool interrupted();
}  // namespace specplan::command
