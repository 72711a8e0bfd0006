// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>

#include "Options.h"
#include "Problem.h"
#include "specplan/planner/SearchReport.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/problems/OmplAppProblem.h"

namespace specplan::command
{
/// A path that was better than those before it.
struct Improvement
{
    double seconds;  ///< since the search began
    double cost;
};

/// One finished search.
struct Run
{
    std::string problem;
    std::string plannerName = "SpeculativeAStar";
    PlannerSettings settings;
    SearchReport report;
    std::shared_ptr<SpeculativeAStar> planner;            ///< empty once results are all that is wanted
    std::shared_ptr<ompl::geometric::SimpleSetup> setup;  ///< likewise
    std::vector<std::vector<double>> expanded;            ///< in order, if asked for; as numbers (copyToReals)
    std::vector<std::uint64_t> order;                     ///< a hash of each of these, if asked for
    std::vector<std::vector<double>> path;                ///< empty if there is none
    std::vector<Improvement> improvements;                ///< of an anytime search, in order
    bool stopped = false;                                 ///< by a limit or the user
    bool interrupted = false;                             ///< by the user

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

/// What to keep of a search besides its figures, and where else to stop it.
struct Watch
{
    bool states = false;                              ///< fills Run::expanded
    bool order = false;                               ///< fills Run::order
    std::shared_ptr<planner::CheckTrace> trace = {};  ///< as SpeculativeAStar::setCheckTrace says; empty for none
    std::optional<std::uint64_t> expansions = {};     ///< stops after so many; needs `order`
};

/// Plans once: until there is a path, on finer lattices too where the problem leaves the lattice to the planner;
/// further with `anytime`. The search stops early at the time limit (of the options, else of the problem's file), or
/// when the user interrupts the program: its status is then "interrupted", unless it had found a path.
[[nodiscard]] Run planOnce(const Problem& problem, const CommonOptions& options, const PlannerSettings& settings,
                           const Watch& watch = {});

/// Lets a run's figures be compared to a baseline that was measured, instead of the sum of its checks' durations.
/// \throws std::logic_error if the order of expansions differs.
void compare(Run& run, const Run& baseline);

/// Tells which lattice planOnce() would search.
void explain(const Problem& problem, const CommonOptions& options, std::ostream& out);

/// The same with any planner, for comparison. Without a time limit it has ten seconds: many of OMPL's planners use all
/// the time there is. Of the report only status, cost and wall time mean anything.
[[nodiscard]] Run planOnceWith(const Problem& problem, const CommonOptions& options,
                               const problems::PlannerRequest& request);
}  // namespace specplan::command
