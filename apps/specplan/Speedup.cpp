// SPDX-License-Identifier: BSD-3-Clause
#include "Speedup.h"

#include <algorithm>
#include <ostream>

#include "Results.h"
#include "SpeedupPlot.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
namespace
{
/// All runs of one problem, in the order of the table.
class Experiment
{
public:
    Experiment(const Problem& problem, const SpeedupOptions& options, Table* table)
        : problem_(problem), options_(options), table_(table)
    {
    }

    void run(std::vector<Run>& runs)
    {
        PlannerSettings settings = options_.planner;
        settings.numThreads = 1;
        Run baseline = planOnce(problem_, options_, settings, false);
        finish(baseline, baseline);
        if (table_ != nullptr)
            table_->add(baseline);
        for (const std::string& policy : options_.policies)
            for (const unsigned threads : options_.threads)
            {
                if (interrupted())
                    return;
                if (threads == 1)
                {
                    // One thread is sequential A*, whatever the policy.
                    runs.push_back(baseline);
                    runs.back().settings.speculationPolicy = policy;
                    continue;
                }
                settings.numThreads = threads;
                settings.speculationPolicy = policy;
                Run next = planOnce(problem_, options_, settings, false);
                finish(next, baseline);
                if (table_ != nullptr)
                    table_->add(next);
                runs.push_back(std::move(next));
            }
    }

private:
    /// Results are all that is kept: planners hold the whole search.
    static void finish(Run& run, const Run& baseline)
    {
        compare(run, baseline);
        run.planner.reset();
        run.setup.reset();
    }

    const Problem& problem_;
    const SpeedupOptions& options_;
    Table* table_;
};
}  // namespace

int speedup(const SpeedupOptions& options, std::ostream& out)
{
    std::vector<std::unique_ptr<Problem>> problems;
    for (const std::string& file : options.problem.files)
        problems.push_back(readProblem(file, options.problem));
    for (const std::string& file : {options.csvFile, options.plotFile})
        if (!file.empty())
            problems::requireWritable(file);
    if (!options.plotFile.empty())
        requireGnuplot();

    Table table(out);
    std::vector<Run> runs;
    for (const auto& problem : problems)
        Experiment(*problem, options, options.json ? nullptr : &table).run(runs);

    if (!options.csvFile.empty())
        problems::writeFile(options.csvFile, [&runs](std::ostream& file) { writeCsv(file, runs); });
    if (!options.plotFile.empty() && !runs.empty())
        plotSpeedup(options.plotFile, runs);
    if (options.json)
    {
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const Run& run : runs)
            rows.push_back(toJson(run));
        out << nlohmann::ordered_json{{"results", rows}}.dump(2) << '\n';
    }
    return !runs.empty() && std::ranges::all_of(runs, &Run::solved) ? 0 : 1;
}
}  // namespace specplan::command
