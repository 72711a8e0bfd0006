// SPDX-License-Identifier: BSD-3-Clause
#include "Speedup.h"

#include <algorithm>
#include <iterator>
#include <ostream>

#include "ExitStatus.h"
#include "Interrupt.h"
#include "Outputs.h"
#include "Progress.h"
#include "Results.h"
#include "SpeedupPlot.h"
#include "Text.h"

namespace specplan::command
{
namespace
{
/// All runs of one problem, in the order of the table.
class Experiment
{
public:
    /// \param table to fill while it runs; null for none.
    Experiment(const Problem& problem, const SpeedupOptions& options, Table* table, SeriesProgress& progress)
        : problem_(problem), options_(options), table_(table), progress_(progress)
    {
    }

    void run(std::vector<Run>& runs)
    {
        PlannerSettings settings = options_.planner;
        settings.numThreads = 1;
        progress_.begin();
        Run baseline = planOnce(problem_, options_, settings);
        if (interrupted())
            return;  // that was not a whole run
        finish(baseline, baseline);
        show(baseline);
        for (const std::string& policy : options_.policies)
            for (const unsigned threads : options_.threads)
            {
                if (threads == 1)
                {
                    // One thread is sequential A*, whatever the policy.
                    runs.push_back(baseline);
                    runs.back().settings.speculationPolicy = policy;
                    continue;
                }
                settings.numThreads = threads;
                settings.speculationPolicy = policy;
                progress_.begin();
                Run next = planOnce(problem_, options_, settings);
                if (interrupted())
                    return;
                finish(next, baseline);
                show(next);
                runs.push_back(std::move(next));
            }
    }

private:
    void show(const Run& run)
    {
        progress_.clear();
        if (table_ != nullptr)
            table_->add(run);
    }

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
    SeriesProgress& progress_;
};

/// Searches of one problem: the sequential one, and what has more than one thread.
std::size_t searchesOf(const SpeedupOptions& options)
{
    const auto many = std::ranges::count_if(options.threads, [](unsigned threads) { return threads > 1; });
    return 1 + options.policies.size() * static_cast<std::size_t>(many);
}

nlohmann::ordered_json toJson(const std::vector<Run>& runs)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Run& run : runs)
        rows.push_back(toJson(run));
    return {{"results", rows}, {"interrupted", interrupted()}};
}

std::vector<std::string> inputsOf(const std::vector<std::unique_ptr<Problem>>& problems)
{
    std::vector<std::string> files;
    for (const auto& problem : problems)
        std::ranges::copy(problem->inputs(), std::back_inserter(files));
    return files;
}
}  // namespace

int speedup(const SpeedupOptions& options, std::ostream& out)
{
    std::vector<std::unique_ptr<Problem>> problems;
    for (const std::string& file : options.problem.files)
        problems.push_back(readProblem(file, options.problem));
    const std::vector<Output> outputs{{"--csv", options.csvFile}, {"--plot", options.plotFile}};
    requireOutputs(outputs, inputsOf(problems), options.json);
    if (!options.plotFile.empty())
        requireGnuplot();

    std::ostream& tables = streamForTables(outputs, out);
    Table table(tables);
    std::vector<Run> runs;
    {
        const StopOnInterrupt stop;
        SeriesProgress progress("search", "searches", problems.size() * searchesOf(options));
        for (const auto& problem : problems)
            if (!interrupted())
                Experiment(*problem, options, options.json ? nullptr : &table, progress).run(runs);
    }
    if (!options.csvFile.empty() && !runs.empty())
        writeOutput(options.csvFile, [&runs](std::ostream& file) { writeCsv(file, runs); });
    if (!options.plotFile.empty() && !runs.empty())
        plotSpeedup(options.plotFile, runs);
    if (options.json)
        out << jsonText(toJson(runs));
    else if (interrupted())
        tables << "interrupted\n";
    if (interrupted())
        return kInterrupted;
    return !runs.empty() && std::ranges::all_of(runs, &Run::solved) ? kSolved : kNotSolved;
}
}  // namespace specplan::command
