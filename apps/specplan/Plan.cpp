// SPDX-License-Identifier: BSD-3-Clause
#include "Plan.h"

#include <ostream>

#include "PlannerList.h"
#include "Predict.h"
#include "Problem.h"
#include "Results.h"
#include "SpeedupPlot.h"
#include "Trace.h"
#include "specplan/planner/CheckTrace.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
namespace
{
/// Whether the trace that is wanted is one of the checks, not of the search.
bool wantsChecks(const PlanOptions& options)
{
    return options.traceFile.ends_with(".csv");
}

void requireOutputs(const Problem& problem, const PlanOptions& options)
{
    if (!options.htmlFile.empty())
        problem.requireView();
    for (const std::string& file :
         {options.svgFile, options.htmlFile, options.traceFile, options.pathFile, options.csvFile, options.plotFile})
        if (!file.empty())
            problems::requireWritable(file);
    if (!options.plotFile.empty())
        requireGnuplot();
    if (wantsChecks(options) && !options.planWith.empty())
        throw problems::InputError(
            "--trace: expected a name that does not end in .csv with --planner, whose checks "
            "are not known");
}

Run search(const Problem& problem, const PlanOptions& options, const std::shared_ptr<planner::CheckTrace>& trace)
{
    if (!options.planWith.empty())
        return planOnceWith(problem, options, parsePlanner(options.planWith));
    PlannerSettings settings = options.planner;
    if (!options.predict.empty())
        settings.numThreads = 1;
    const bool keepOrder =
        !options.svgFile.empty() || !options.htmlFile.empty() || (!options.traceFile.empty() && !wantsChecks(options));
    return planOnce(problem, options, settings, keepOrder, trace);
}

void writeFiles(const Problem& problem, const PlanOptions& options, const Run& run)
{
    if (!options.svgFile.empty())
        problems::writeFile(options.svgFile, [&](std::ostream& file) { problem.draw(file, run); });
    if (!options.htmlFile.empty())
        problems::writeFile(options.htmlFile, [&](std::ostream& file) { problem.writeView(file, run); });
    if (wantsChecks(options))
        problems::writeFile(options.traceFile, [&](std::ostream& file) { writeChecks(file, run); });
    else if (!options.traceFile.empty())
        problems::writeFile(options.traceFile,
                            [&](std::ostream& file)
                            {
                                nlohmann::ordered_json trace = toJson(run);
                                problem.describe(trace, run);
                                file << trace.dump() << '\n';
                            });
    if (!options.pathFile.empty() && run.solved())
        problems::writeFile(options.pathFile,
                            [&](std::ostream& file) { run.setup->getSolutionPath().printAsMatrix(file); });
}

void report(std::ostream& out, const PlanOptions& options, const Run& run, const std::vector<Run>& predictions)
{
    if (options.json)
    {
        nlohmann::ordered_json json = toJson(run);
        for (const Run& prediction : predictions)
            json["predictions"].push_back(toJson(prediction));
        out << json.dump(2) << '\n';
        return;
    }
    printRun(out, run);
    if (predictions.empty())
        return;
    out << "\nWith so many threads, as many processors and the same checks:\n";
    Table table(out);
    for (const Run& prediction : predictions)
        table.add(prediction);
}
}  // namespace

int plan(const PlanOptions& options, std::ostream& out)
{
    const std::unique_ptr<Problem> problem = readProblem(options.problem.files.front(), options.problem);
    if (options.explain)
    {
        explain(*problem, options, out);
        return 0;
    }
    requireOutputs(*problem, options);
    const auto trace = wantsChecks(options) || !options.predict.empty() ? std::make_shared<planner::CheckTrace>()
                                                                        : std::shared_ptr<planner::CheckTrace>();
    const Run run = search(*problem, options, trace);
    writeFiles(*problem, options, run);
    std::vector<Run> predictions;
    if (!options.predict.empty())
        predictions = predict(*problem, options, run, trace);
    if (!options.csvFile.empty() && !predictions.empty())
        problems::writeFile(options.csvFile, [&](std::ostream& file) { writeCsv(file, predictions); });
    if (!options.plotFile.empty() && !predictions.empty())
        plotSpeedup(options.plotFile, predictions);
    report(out, options, run, predictions);
    return run.solved() ? 0 : 1;
}
}  // namespace specplan::command
