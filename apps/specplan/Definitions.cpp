// SPDX-License-Identifier: BSD-3-Clause
#include "Definitions.h"

#include <cmath>
#include <functional>
#include <map>

#include "Text.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
using problems::concat;
using problems::InputError;
using problems::inQuotes;

namespace
{
/// A number as every reader of the project takes it: decimal and finite.
CLI::Validator number(double low, double high)
{
    const std::string range = concat("from ", low, " to ", high);
    return {[low, high, range](std::string& text)
            {
                double value = 0.0;
                if (problems::parse(text, value) && value >= low && value <= high)
                    return std::string();
                return concat("expected a number ", range, ", found ", inQuotes(text));
            },
            range};
}

/// The same of whole numbers.
CLI::Validator wholeNumber(int low, int high)
{
    const std::string range = concat(low, " to ", high);
    return {[low, high, range](std::string& text)
            {
                int value = 0;
                if (!problems::parse(text, value) || value < low || value > high)
                    return concat("expected a whole number from ", range, ", found ", inQuotes(text));
                text = std::to_string(value);  // a leading 0 means nothing
                return std::string();
            },
            range};
}

/// One of some words, which the help shows too.
CLI::Option* oneOf(CLI::Option* option, const std::vector<std::string>& words)
{
    std::string all;
    for (const std::string& word : words)
        all += (all.empty() ? "" : "|") + word;
    return option->type_name(all)->check(CLI::IsMember(words).description(""));
}

/// An option whose value is read by a function, which throws InputError.
CLI::Option* addText(CLI::App& app, const std::string& name, const std::string& description,
                     const std::function<void(const std::string&)>& read)
{
    return app.add_option_function<std::string>(name, read, description);
}

CLI::Option* addFile(CLI::App& app, const std::string& name, std::string& file, const std::string& description)
{
    return app.add_option(name, file, description)->type_name("FILE");
}

void addValidityResolution(CLI::App& app, std::optional<double>& resolution)
{
    app.add_option("--validity-resolution", resolution,
                   "Motions of a .cfg problem are checked this often: share of the space's extent [the file's, or "
                   "0.01]")
        ->type_name("SHARE")
        ->transform(number(1e-6, 1.0));
}

void addArtificialCheck(CLI::App& app, problems::ArtificialCheck& check)
{
    CLI::Option* latency = addText(app, "--check-latency", "Each check sleeps this long, such as 5ms",
                                   [&check](const std::string& text) {
                                       check = {parseDuration("--check-latency", text), false};
                                   });
    latency->type_name("TIME");
    addText(app, "--check-busy", "Each check burns CPU this long, such as 100us",
            [&check](const std::string& text) {
                check = {parseDuration("--check-busy", text), true};
            })
        ->type_name("TIME")
        ->excludes(latency);
}

void addJson(CLI::App& app, bool& json)
{
    app.add_flag("--json", json, "Print one JSON object and nothing else");
}

void addProblemOptions(CLI::App& app, ProblemOptions& options, bool several)
{
    app.add_option("PROBLEM", options.files,
                   "Moving AI .map, map in the seed's text format, or OMPL.app .cfg; - is standard input")
        ->required()
        ->type_name("")
        ->expected(1, several ? -1 : 1);
    CLI::Option* start = addText(app, "--start", "Start cell x,y",
                                 [&options](const std::string& text) { options.start = parseCell("--start", text); });
    CLI::Option* goal = addText(app, "--goal", "Goal cell x,y",
                                [&options](const std::string& text) { options.goal = parseCell("--goal", text); });
    start->type_name("X,Y");
    goal->type_name("X,Y");
    addFile(app, "--scen", options.scenario, "Moving AI scenario [PROBLEM.scen if there is one]")
        ->excludes(start)
        ->excludes(goal);
    app.add_option("--index", options.index, "Entry of the scenario, from 0, or 'last'")
        ->type_name("I")
        ->capture_default_str();
    const std::map<std::string, problems::GridCost> costs{{"length", problems::GridCost::Length},
                                                          {"steps", problems::GridCost::Steps},
                                                          {"seed", problems::GridCost::Seed}};
    app.add_option("--cost", options.cost,
                   "length: octile length; steps: 1 a move; seed: 1 a move, Euclidean heuristic")
        ->transform(CLI::CheckedTransformer(costs).description(""))
        ->type_name("length|steps|seed")
        ->default_str("length");
    app.add_flag("--corner-cutting", options.cornerCutting,
                 "Allow diagonal moves past a blocked corner (always so in the seed's format)");
    addValidityResolution(app, options.validityResolution);
}

void addSearchOptions(CLI::App& app, CommonOptions& options)
{
    PlannerSettings& planner = options.planner;
    app.add_option("--lookahead", planner.lookahead, "Steps that the direction policy looks ahead")
        ->type_name("N")
        ->transform(wholeNumber(1, 1000))
        ->capture_default_str();
    app.add_flag("--barrier", planner.barrier, "Wait for all running checks at every expansion, as in the paper");
    app.add_option("--weight", planner.weight, "Weight of the heuristic [1 up to four axes, 3 up to seven, 5 above]")
        ->type_name("W")
        ->transform(number(1.0, 1e9));
    oneOf(app.add_option("--evaluation", planner.evaluation,
                         "Check what A* meets, or only what lies on a path that may be the best"),
          evaluations())
        ->capture_default_str();
    addArtificialCheck(app, options.check);
    oneOf(app.add_option("--executor", planner.executor, "Real threads, or a simulated clock"), {"threads", "virtual"})
        ->capture_default_str();
    addText(app, "--time-limit", "Stop each search after this time, such as 10s [a .cfg's own]",
            [&options](const std::string& text) { options.timeLimit = parseDuration("--time-limit", text); })
        ->type_name("TIME");
    addJson(app, options.json);
}

/// What has to do with more than one search.
void addComparisons(CLI::App& app, PlanOptions& options, CLI::Option* threads)
{
    CLI::Option* verify = app.add_flag("--verify", options.verify,
                                       "Search with one thread and no speculation too, and compare order of "
                                       "expansions, path and cost; takes as long as sequential A*");
    app.add_option("--planner", options.planWith,
                   "Plan with another planner of OMPL, such as RRTConnect:range=5, for comparison; 10 s at most")
        ->type_name("NAME[:K=V;...]")
        ->excludes(verify);
    CLI::Option* predict =
        addText(app, "--predict",
                "Search with one thread, and tell from the durations of its checks how long it "
                "takes with so many, such as 1,2,4 or 1..256",
                [&options](const std::string& text) { options.predict = parseWorkers("--predict", text); });
    predict->type_name("N,...|N..M")->excludes(threads)->excludes(verify);
    for (const char* other : {"--executor", "--planner", "--anytime", "--explain"})
        predict->excludes(other);
    addFile(app, "--csv", options.csvFile, "Write the predictions")->needs(predict);
    addFile(app, "--plot", options.plotFile, "Plot the predicted speed-up, as SVG")->needs(predict);
}

void addPictures(CLI::App& app, PlanOptions& options)
{
    addFile(app, "--svg", options.svgFile, "Draw the search");
    addFile(app, "--html", options.htmlFile,
            "Write a page with a 3-D view of a .cfg problem: world, robot along the path, states of the search; any "
            "browser shows it, no network needed");
    addFile(app, "--trace", options.traceFile,
            "Write the search as JSON: map, order of expansions, path; or, where FILE ends in .csv, its checks: what "
            "each one found and how long it took");
    addFile(app, "--path", options.pathFile, "Write the path, one state a line");
}
}  // namespace

void definePlan(CLI::App& app, PlanOptions& options)
{
    addProblemOptions(app, options.problem, false);
    CLI::Option* threads =
        app.add_option("--threads", options.planner.numThreads, "Checks at once; 0: number of cores, 1: sequential A*")
            ->type_name("N")
            ->transform(wholeNumber(0, 4096))
            ->capture_default_str();
    oneOf(app.add_option("--policy", options.planner.speculationPolicy, "What to check ahead"), speculationPolicies())
        ->capture_default_str();
    addSearchOptions(app, options);
    app.add_flag("--anytime", options.anytime,
                 "Go on after the first path until the time limit: smaller weights, then finer lattices");
    app.add_flag("--explain", options.explain,
                 "Search nothing; tell the lattice that would be searched: axes, steps, size, checks, goals")
        ->excludes("--json");
    addComparisons(app, options, threads);
    addPictures(app, options);
}

void defineBenchmark(CLI::App& app, BenchmarkOptions& options)
{
    app.add_option("PROBLEM", options.file, "OMPL.app .cfg, or a map with a scenario beside it; - is standard input")
        ->required()
        ->type_name("");
    addValidityResolution(app, options.validityResolution);
    app.add_option("--planners", options.planners,
                   "Planners, separated by commas: OMPL's geometric ones, and SpeculativeAStar in any number of "
                   "configurations such as 'SpeculativeAStar:num_threads=1;weight=2' [those of the file]")
        ->type_name("NAME[:K=V;...],...");
    app.add_option("--runs", options.runs, "Runs of each planner [the file's, or 10]")
        ->type_name("N")
        ->transform(wholeNumber(1, 1000000));
    addText(app, "--time-limit", "Of each run, such as 10s [the file's, or 10s]",
            [&options](const std::string& text)
            {
                options.timeLimit = parseDuration("--time-limit", text);
                if (options.timeLimit->count() == 0)
                    throw InputError("--time-limit: expected more than 0s");
            })
        ->type_name("TIME");
    app.add_option("--memory-limit", options.memoryLimit, "Of each run, MB [the file's, or 4096]")
        ->type_name("MB")
        ->transform(number(1.0, 1e9));
    addArtificialCheck(app, options.check);
    app.add_flag("--simplify", options.simplify, "Simplify each path too, with OMPL's defaults");
    addFile(app, "--log", options.logFile, "Write OMPL's benchmark log");
    addJson(app, options.json);
}

void defineSpeedup(CLI::App& app, SpeedupOptions& options)
{
    addProblemOptions(app, options.problem, true);
    addText(app, "--threads", "Numbers of threads, such as 1,2,4 or 1..256",
            [&options](const std::string& text) { options.threads = parseWorkers("--threads", text); })
        ->type_name("N,...|N..M")
        ->default_str("1..32");
    oneOf(app.add_option("--policies", options.policies, "Policies, separated by commas")->delimiter(','),
          speculationPolicies())
        ->capture_default_str();
    addSearchOptions(app, options);
    addFile(app, "--csv", options.csvFile, "Write all figures");
    addFile(app, "--plot", options.plotFile, "Plot speed-up against threads, as SVG");
}
}  // namespace specplan::command
