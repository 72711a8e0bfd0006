// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>

#include <ompl/util/Console.h>

#include "Benchmark.h"
#include "Plan.h"
#include "Run.h"
#include "Speedup.h"
#include "Text.h"
#include "specplan/Version.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
using problems::concat;
using problems::InputError;

namespace
{
constexpr int kBadInput = 2;

/// Options given as text that need more than a conversion.
struct RawOptions
{
    std::string start;
    std::string goal;
    std::string latency;
    std::string busy;
    std::string timeLimit;
    std::string predict;
};

void addValidityResolution(CLI::App& app, std::optional<double>& resolution)
{
    app.add_option(
           "--validity-resolution", resolution,
           "Motions of a .cfg problem are checked this often: share of the space's extent [the file's, or 0.01]")
        ->check(CLI::Range(1e-6, 1.0));
}

void addProblemOptions(CLI::App& app, ProblemOptions& options, RawOptions& raw)
{
    app.add_option("PROBLEM", options.files, "Moving AI .map, map in the seed's text format, or OMPL.app .cfg")
        ->required();
    CLI::Option* start = app.add_option("--start", raw.start, "Start cell x,y")->type_name("X,Y");
    CLI::Option* goal = app.add_option("--goal", raw.goal, "Goal cell x,y")->type_name("X,Y");
    app.add_option("--scen", options.scenario, "Moving AI scenario [PROBLEM.scen if there is one]")
        ->type_name("FILE")
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
        ->transform(CLI::CheckedTransformer(costs).description("length|steps|seed"))
        ->default_str("length");
    app.add_flag("--corner-cutting", options.cornerCutting,
                 "Allow diagonal moves past a blocked corner (always so in the seed's format)");
    addValidityResolution(app, options.validityResolution);
}

void addSearchOptions(CLI::App& app, CommonOptions& options, RawOptions& raw)
{
    PlannerSettings& planner = options.planner;
    app.add_option("--lookahead", planner.lookahead, "Steps that the direction policy looks ahead")
        ->check(CLI::Range(1U, 1000U))
        ->capture_default_str();
    app.add_flag("--barrier", planner.barrier, "Wait for all running checks at every expansion, as in the paper");
    app.add_option("--weight", planner.weight, "Weight of the heuristic [1 up to four axes, 3 up to seven, 5 above]")
        ->check(CLI::Range(1.0, 1e9));
    app.add_option("--evaluation", planner.evaluation,
                   "eager|lazy: check what A* meets, or only what lies on a path that may be the best")
        ->check(CLI::IsMember(evaluations()))
        ->capture_default_str();
    CLI::Option* latency =
        app.add_option("--check-latency", raw.latency, "Each check sleeps this long, such as 5ms")->type_name("TIME");
    app.add_option("--check-busy", raw.busy, "Each check burns CPU this long, such as 100us")
        ->type_name("TIME")
        ->excludes(latency);
    app.add_option("--executor", planner.executor, "threads|virtual: real threads, or a simulated clock")
        ->check(CLI::IsMember({"threads", "virtual"}))
        ->capture_default_str();
    app.add_option("--time-limit", raw.timeLimit, "Stop each search after this time, such as 10s [a .cfg's own]")
        ->type_name("TIME");
    app.add_flag("--json", options.json, "Print one JSON object and nothing else");
}

void addBenchmarkOptions(CLI::App& app, BenchmarkOptions& options, RawOptions& raw)
{
    app.add_option("PROBLEM", options.file, "OMPL.app .cfg, or a map with a scenario beside it")->required();
    addValidityResolution(app, options.validityResolution);
    app.add_option("--planners", options.planners,
                   "Planners, separated by commas: OMPL's geometric ones, and SpeculativeAStar in any number of "
                   "configurations such as 'SpeculativeAStar:num_threads=1;weight=2' [those of the file]")
        ->type_name("NAME[:K=V;...],...");
    app.add_option("--runs", options.runs, "Runs of each planner [the file's, or 10]")->check(CLI::Range(1U, 1000000U));
    app.add_option("--time-limit", raw.timeLimit, "Of each run, such as 10s [the file's, or 10s]")->type_name("TIME");
    app.add_option("--memory-limit", options.memoryLimit, "Of each run, MB [the file's, or 4096]")
        ->check(CLI::Range(1.0, 1e9));
    CLI::Option* latency =
        app.add_option("--check-latency", raw.latency, "Each check sleeps this long, such as 5ms")->type_name("TIME");
    app.add_option("--check-busy", raw.busy, "Each check burns CPU this long, such as 100us")
        ->type_name("TIME")
        ->excludes(latency);
    app.add_flag("--simplify", options.simplify, "Simplify each path too, with OMPL's defaults");
    app.add_option("--log", options.logFile, "Write OMPL's benchmark log")->type_name("FILE");
    app.add_flag("--json", options.json, "Print one JSON object and nothing else");
}

problems::ArtificialCheck artificialCheck(const RawOptions& raw)
{
    if (!raw.busy.empty())
        return {parseDuration("--check-busy", raw.busy), true};
    return {raw.latency.empty() ? std::chrono::nanoseconds(0) : parseDuration("--check-latency", raw.latency), false};
}

void finishBenchmark(BenchmarkOptions& options, const RawOptions& raw)
{
    options.check = artificialCheck(raw);
    if (raw.timeLimit.empty())
        return;
    options.timeLimit = parseDuration("--time-limit", raw.timeLimit);
    if (options.timeLimit->count() == 0)
        throw InputError("--time-limit: expected more than 0s");
}

/// Reads what was given as text. \param single whether one problem is all there may be. \throws InputError naming the
/// option.
void finish(CommonOptions& options, const RawOptions& raw, bool single)
{
    if (!raw.start.empty())
        options.problem.start = parseCell("--start", raw.start);
    if (!raw.goal.empty())
        options.problem.goal = parseCell("--goal", raw.goal);
    options.check = artificialCheck(raw);
    if (!raw.timeLimit.empty())
        options.timeLimit = parseDuration("--time-limit", raw.timeLimit);
    if (single && options.problem.files.size() > 1)
        throw InputError(concat("PROBLEM: expected one, found ", options.problem.files.size()));
    if (options.problem.files.size() > 1 &&
        (options.problem.start || options.problem.goal || !options.problem.scenario.empty()))
        throw InputError("--start, --goal and --scen: expected a single PROBLEM with these");
}

std::string oneLine(std::string text)
{
    std::ranges::replace(text, '\n', ' ');
    return text;
}
}  // namespace

int run(int argc, char** argv)
{
    CLI::App app("Lattice planning with expensive validity checks, on many cores at once");
    app.set_version_flag("--version", SPECPLAN_VERSION);
    app.require_subcommand(1);
    RawOptions raw;

    PlanOptions planOptions;
    CLI::App* planApp = app.add_subcommand("plan", "Solve one problem");
    addProblemOptions(*planApp, planOptions.problem, raw);
    CLI::Option* threads = planApp
                               ->add_option("--threads", planOptions.planner.numThreads,
                                            "Checks at once; 0: number of cores, 1: sequential A*")
                               ->check(CLI::Range(0U, 4096U))
                               ->capture_default_str();
    planApp->add_option("--policy", planOptions.planner.speculationPolicy, "What to check ahead")
        ->check(CLI::IsMember(speculationPolicies()))
        ->capture_default_str();
    addSearchOptions(*planApp, planOptions, raw);
    planApp->add_flag("--anytime", planOptions.anytime,
                      "Go on after the first path until the time limit: smaller weights, then finer lattices");
    planApp
        ->add_flag("--explain", planOptions.explain,
                   "Search nothing; tell the lattice that would be searched: axes, steps, size, checks, goals")
        ->excludes("--json");
    planApp
        ->add_option("--planner", planOptions.planWith,
                     "Plan with another planner of OMPL, such as RRTConnect:range=5, for comparison; 10 s at most")
        ->type_name("NAME[:K=V;...]");
    CLI::Option* predict =
        planApp
            ->add_option("--predict", raw.predict,
                         "Search with one thread, and tell from the durations of its checks how long it takes with "
                         "so many, such as 1,2,4 or 1..256")
            ->type_name("N,...|N..M")
            ->excludes(threads)
            ->excludes("--executor")
            ->excludes("--planner")
            ->excludes("--anytime")
            ->excludes("--explain");
    planApp->add_option("--csv", planOptions.csvFile, "Write the predictions")->type_name("FILE")->needs(predict);
    planApp->add_option("--plot", planOptions.plotFile, "Plot the predicted speed-up, as SVG")
        ->type_name("FILE")
        ->needs(predict);
    planApp->add_option("--svg", planOptions.svgFile, "Draw the search")->type_name("FILE");
    planApp
        ->add_option("--html", planOptions.htmlFile,
                     "Write a page with a 3-D view of a .cfg problem: world, robot along the path, states of the "
                     "search; any browser shows it, no network needed")
        ->type_name("FILE");
    planApp
        ->add_option(
            "--trace", planOptions.traceFile,
            "Write the search as JSON: map, order of expansions, path; or, where FILE ends in .csv, its checks: what "
            "each one found and how long it took")
        ->type_name("FILE");
    planApp->add_option("--path", planOptions.pathFile, "Write the path, one state a line")->type_name("FILE");

    BenchmarkOptions benchmarkOptions;
    CLI::App* benchmarkApp = app.add_subcommand("benchmark", "Run OMPL's Benchmark over several planners");
    addBenchmarkOptions(*benchmarkApp, benchmarkOptions, raw);

    SpeedupOptions speedupOptions;
    CLI::App* speedupApp = app.add_subcommand("speedup", "Measure every policy with every number of threads");
    addProblemOptions(*speedupApp, speedupOptions.problem, raw);
    speedupApp->add_option("--threads", speedupOptions.threads, "Numbers of threads, separated by commas")
        ->delimiter(',')
        ->check(CLI::Range(1U, 4096U))
        ->capture_default_str();
    speedupApp->add_option("--policies", speedupOptions.policies, "Policies, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(speculationPolicies()))
        ->capture_default_str();
    addSearchOptions(*speedupApp, speedupOptions, raw);
    speedupApp->add_option("--csv", speedupOptions.csvFile, "Write all figures")->type_name("FILE");
    speedupApp->add_option("--plot", speedupOptions.plotFile, "Plot speed-up against threads, as SVG")
        ->type_name("FILE");

    try
    {
        app.parse(argc, argv);
        ompl::msg::setLogLevel(ompl::msg::LOG_WARN);  // standard output is for results
        stopOnInterrupt();
        if (planApp->parsed())
        {
            finish(planOptions, raw, true);
            if (predict->count() > 0)
                planOptions.predict = parseWorkers("--predict", raw.predict);
            return plan(planOptions, std::cout);
        }
        if (benchmarkApp->parsed())
        {
            finishBenchmark(benchmarkOptions, raw);
            return benchmark(benchmarkOptions, std::cout);
        }
        finish(speedupOptions, raw, false);
        return speedup(speedupOptions, std::cout);
    }
    catch (const CLI::Success& wish)  // help or version
    {
        return app.exit(wish);
    }
    catch (const CLI::ParseError& error)
    {
        std::cerr << "specplan: " << oneLine(error.what()) << " (see specplan --help)\n";
        return kBadInput;
    }
    catch (const std::exception& error)
    {
        std::cerr << "specplan: " << oneLine(error.what()) << '\n';
        return kBadInput;
    }
}
}  // namespace specplan::command
