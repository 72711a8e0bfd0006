// SPDX-License-Identifier: BSD-3-Clause
#include "Predict.h"

#include <algorithm>
#include <iostream>

#include "Interrupt.h"
#include "specplan/planner/CheckTrace.h"

namespace specplan::command
{
namespace
{
/// Runs recorded searches again on the clock of a simulated pool.
class Replay
{
public:
    Replay(const Problem& problem, const PlanOptions& options, const Run& recorded,
           std::shared_ptr<planner::CheckTrace> trace)
        : problem_(problem), options_(options), recorded_(recorded), trace_(std::move(trace))
    {
        options_.timeLimit = std::chrono::hours(24 * 365);  // a search that came to its end does so again
    }

    /// Finds out by how much the search's own work takes longer between real checks.
    void learnAfterCheck()
    {
        const Run alone = run(1);
        const double longer = recorded_.report.searchTime - alone.report.searchTime;
        if (longer > 0.0 && recorded_.report.checksTotal > 0)
            trace_->setAfterCheck(longer / static_cast<double>(recorded_.report.checksTotal));
    }

    [[nodiscard]] Run run(unsigned workers) const
    {
        PlannerSettings settings = options_.planner;
        settings.executor = "virtual";
        settings.numThreads = workers;
        Run run = planOnce(problem_, options_, settings, {.trace = trace_});
        // Before and after the search there is what cannot be shared out: taking starts and goals, the lattice.
        const SearchReport& report = recorded_.report;
        run.report.virtualTime += report.wallTime - report.searchTime - report.waitTime;
        // Whatever disturbed the recorded run would count as saved by more workers: never more than so many times as
        // fast.
        run.report.virtualTime = std::max(run.report.virtualTime, report.wallTime / workers);
        if (workers == 1)
            run.report.virtualTime = report.wallTime;
        run.report.wallTime = run.report.virtualTime;
        run.planner.reset();
        run.setup.reset();
        return run;
    }

private:
    const Problem& problem_;
    PlanOptions options_;
    const Run& recorded_;
    std::shared_ptr<planner::CheckTrace> trace_;
};
}  // namespace

std::vector<Run> predict(const Problem& problem, const PlanOptions& options, const Run& recorded,
                         const std::shared_ptr<planner::CheckTrace>& trace)
{
    if (!recorded.solved() && recorded.report.status != "infeasible")
    {
        std::cerr << "specplan: warning: --predict: nothing is predicted from a search that did not come to its end ("
                  << recorded.report.status << ")\n";
        return {};
    }
    Replay replay(problem, options, recorded, trace);
    replay.learnAfterCheck();
    std::vector<Run> runs;
    for (const unsigned workers : options.predict)
    {
        if (interrupted())
            break;
        runs.push_back(replay.run(workers));
        compare(runs.back(), recorded);
    }
    return runs;
}
}  // namespace specplan::command
