// SPDX-License-Identifier: BSD-3-Clause
#include "Plan.h"

#include <iostream>
#include <optional>

#include "ExitStatus.h"
#include "Interrupt.h"
#include "Outputs.h"
#include "PlannerList.h"
#include "Predict.h"
#include "Problem.h"
#include "Results.h"
#include "SpeedupPlot.h"
#include "Text.h"
#include "Trace.h"
#include "Verify.h"
#include "specplan/planner/CheckTrace.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
namespace
{
/// Whether the trace that is wanted is one of the checks, not of the search.
bool wantsChecks(const PlanOptions& options)
{
    return options.traceFile.ends_with(".csv");
}

std::vector<Output> outputsOf(const PlanOptions& options)
{
    return {{"--svg", options.svgFile},   {"--html", options.htmlFile}, {"--trace", options.traceFile},
            {"--path", options.pathFile}, {"--csv", options.csvFile},   {"--plot", options.plotFile}};
}

void requireAll(const Problem& problem, const PlanOptions& options)
{
    if (!options.htmlFile.empty())
        problem.requireView();
    requireOutputs(outputsOf(options), problem.inputs(), options.json);
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
    const bool states =
        !options.svgFile.empty() || !options.htmlFile.empty() || (!options.traceFile.empty() && !wantsChecks(options));
    return planOnce(problem, options, settings, {.states = states, .order = options.verify, .trace = trace});
}

void writeFiles(const Problem& problem, const PlanOptions& options, const Run& run)
{
    if (!options.svgFile.empty())
        writeOutput(options.svgFile, [&](std::ostream& file) { problem.draw(file, run); });
    if (!options.htmlFile.empty())
        writeOutput(options.htmlFile, [&](std::ostream& file) { problem.writeView(file, run); });
    if (wantsChecks(options))
        writeOutput(options.traceFile, [&](std::ostream& file) { writeChecks(file, run); });
    else if (!options.traceFile.empty())
        writeOutput(options.traceFile,
                    [&](std::ostream& file)
                    {
                        nlohmann::ordered_json trace = toJson(run);
                        problem.describe(trace, run);
                        file << compactJsonText(trace);
                    });
    if (!options.pathFile.empty() && run.solved())
        writeOutput(options.pathFile, [&](std::ostream& file) { run.setup->getSolutionPath().printAsMatrix(file); });
}

/// All that came of the options.
struct Results
{
    Run run;
    std::vector<Run> predictions;
    std::optional<Verification> verification;
};

Results runAll(const Problem& problem, const PlanOptions& options)
{
    const StopOnInterrupt stop;
    const auto trace = wantsChecks(options) || !options.predict.empty() ? std::make_shared<planner::CheckTrace>()
                                                                        : std::shared_ptr<planner::CheckTrace>();
    Results results{search(problem, options, trace), {}, {}};
    if (!options.predict.empty())
        results.predictions = predict(problem, options, results.run, trace);
    if (options.verify)
        results.verification = verify(problem, options, results.run);
    return results;
}

void report(std::ostream& out, const PlanOptions& options, const Results& results)
{
    if (options.json)
    {
        nlohmann::ordered_json json = toJson(results.run);
        json["interrupted"] = results.run.interrupted;
        for (const Run& prediction : results.predictions)
            json["predictions"].push_back(toJson(prediction));
        if (results.verification)
            json["verification"] = toJson(*results.verification, results.run);
        out << jsonText(json);
        return;
    }
    printRun(out, results.run);
    if (results.verification)
        printVerification(out, *results.verification, results.run);
    if (results.predictions.empty())
        return;
    out << "\nWith so many threads, as many processors and the same checks:\n";
    Table table(out);
    for (const Run& prediction : results.predictions)
        table.add(prediction);
}

int statusOf(const Results& results)
{
    if (results.verification && !results.verification->difference.empty())
    {
        std::cerr << "specplan: --verify: " << results.verification->difference << "; please report this\n";
        return kOwnFault;
    }
    if (results.run.report.status == "interrupted" || (results.verification && results.verification->interrupted))
        return kInterrupted;
    return results.run.solved() ? kSolved : kNotSolved;
}
}  // namespace

int plan(const PlanOptions& options, std::ostream& out)
{
    const std::unique_ptr<Problem> problem = readProblem(options.problem.files.front(), options.problem);
    if (options.explain)
    {
        explain(*problem, options, out);
        return kSolved;
    }
    requireAll(*problem, options);
    const Results results = runAll(*problem, options);
    writeFiles(*problem, options, results.run);
    if (!options.csvFile.empty() && !results.predictions.empty())
        writeOutput(options.csvFile, [&](std::ostream& file) { writeCsv(file, results.predictions); });
    if (!options.plotFile.empty() && !results.predictions.empty())
        plotSpeedup(options.plotFile, results.predictions);
    report(streamForTables(outputsOf(options), out), options, results);
    return statusOf(results);
}
}  // namespace specplan::command
