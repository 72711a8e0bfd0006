// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmark.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/Console.h>

#include "ExitStatus.h"
#include "Interrupt.h"
#include "InterruptiblePlanner.h"
#include "Outputs.h"
#include "PlannerList.h"
#include "Problem.h"
#include "Progress.h"
#include "Run.h"
#include "Text.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/PlannerCatalog.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
namespace ob = ompl::base;
using problems::concat;
using problems::InputError;
using RunProperties = ompl::tools::Benchmark::RunProperties;

namespace
{
constexpr double kTimeLimit = 10.0;      // seconds a run
constexpr double kMemoryLimit = 4096.0;  // MB a run
constexpr unsigned kRuns = 10;

/// Leaves OMPL's Benchmark, which catches errors but not this.
struct Interrupt
{
};

/// OMPL's Benchmark, of which what is done is kept when the user interrupts it.
class KeepingBenchmark : public ompl::tools::Benchmark
{
public:
    using ompl::tools::Benchmark::Benchmark;

    void run(const Request& request)
    {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point begin = Clock::now();
        ompl::msg::OutputHandler* output = ompl::msg::getOutputHandler();
        try
        {
            benchmark(request);
        }
        catch (const Interrupt&)
        {
            status_.running = false;
            exp_.totalDuration = std::chrono::duration<double>(Clock::now() - begin).count();
            std::erase_if(exp_.planners, [](const PlannerExperiment& planner) { return planner.runs.empty(); });
        }
        ompl::msg::useOutputHandler(output);
    }
};

/// Columns that only our planner has.
void addReport(RunProperties& run, const SearchReport& report)
{
    run["bound REAL"] = concat(report.bound);
    run["refinements INTEGER"] = std::to_string(report.refinements);
    run["checks reused INTEGER"] = std::to_string(report.checksReused);
    run["expansions INTEGER"] = std::to_string(report.expansions);
    run["checks used INTEGER"] = std::to_string(report.checksUsed);
    run["checks total INTEGER"] = std::to_string(report.checksTotal);
    run["speculative checks INTEGER"] = std::to_string(report.speculativeChecks - report.speculativeDropped);
    run["speculative used INTEGER"] = std::to_string(report.speculativeUsed);
    run["accuracy REAL"] = concat(report.accuracy);
    run["coverage REAL"] = concat(report.coverage);
    run["timeliness REAL"] = concat(report.timeliness);
    run["wait time REAL"] = concat(report.waitTime);
    run["search time REAL"] = concat(report.searchTime);
    run["speedup REAL"] = concat(report.speedup);
    run["threads INTEGER"] = std::to_string(report.threads);
}

/// How the cost fell in each run, by the name that Benchmark gives the planner.
using CostsOfRuns = std::map<std::string, std::vector<std::vector<Convergence::Point>>>;

/// Columns about the way to the last cost; only in runs that found a path.
void addConvergence(RunProperties& run, const std::vector<Convergence::Point>& points)
{
    if (points.empty())
        return;
    run["first path time REAL"] = concat(points.front().time);
    run["first path cost REAL"] = concat(points.front().cost);
    run["last cost REAL"] = concat(points.back().cost);
}

/// Whether the path found is still valid when it is looked at ten times as often as the planner had to: "1" or "0".
std::string holdsAtFinerResolution(const ob::ProblemDefinition& problem)
{
    constexpr unsigned kFiner = 10;
    const ob::SpaceInformation& si = *problem.getSpaceInformation();
    auto* path = problem.getSolutionPath()->as<ompl::geometric::PathGeometric>();
    ob::ScopedState<> between(problem.getSpaceInformation()->getStateSpace());
    for (unsigned i = 1; i < path->getStateCount(); ++i)
    {
        const ob::State* from = path->getState(i - 1);
        const ob::State* to = path->getState(i);
        const unsigned count = kFiner * std::max(si.getStateSpace()->validSegmentCount(from, to), 1U);
        for (unsigned k = 0; k <= count; ++k)
        {
            si.getStateSpace()->interpolate(from, to, static_cast<double>(k) / count, between.get());
            if (!si.isValid(between.get()))
                return "0";
        }
    }
    return "1";
}

/// What the kind of problem settles; to go on while there is time is the planner's own choice here, as with others.
PlannerSettings settled(const Problem& problem, const PlannerSettings& chosen)
{
    PlannerSettings settings = problem.settle(chosen);
    settings.anytime = chosen.anytime;
    return settings;
}

/// Makes the planners and adds them. \throws InputError, with the place in the file if it asks for them.
void addPlanners(KeepingBenchmark& benchmark, const Problem& problem,
                 const std::vector<problems::PlannerRequest>& requests, const ob::SpaceInformationPtr& si,
                 const std::shared_ptr<const CountingChecker>& checker)
{
    for (const problems::PlannerRequest& request : requests)
    {
        try
        {
            const ob::PlannerPtr planner = problems::makePlanner(request.name, request.parameters, si);
            if (auto* ours = dynamic_cast<SpeculativeAStar*>(planner.get()))
                ours->setSettings(settled(problem, ours->getSettings()));
            benchmark.addPlanner(std::make_shared<InterruptiblePlanner>(planner, checker));
        }
        catch (const InputError& error)
        {
            if (request.line == 0)
                throw;
            throw InputError(problem.name(), request.line, error.what());
        }
    }
}

bool isSolved(const RunProperties& run)
{
    const auto solved = run.find("solved BOOLEAN");
    return solved != run.end() && solved->second == "1";
}

/// The middle value of a column over the runs that have it; NaN if none has.
double median(const std::vector<RunProperties>& runs, const std::string& column)
{
    std::vector<double> values;
    for (const RunProperties& run : runs)
        if (const auto found = run.find(column); found != run.end())
            if (double value = 0.0; problems::parse(found->second, value))
                values.push_back(value);
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

std::string numberText(double value, int places)
{
    return std::isnan(value) ? "-" : fixed(value, places);
}

void printTable(std::ostream& out, const ompl::tools::Benchmark::CompleteExperiment& experiment, bool whole)
{
    constexpr int kColumn = 14;
    std::size_t widest = 7;
    for (const auto& planner : experiment.planners)
        widest = std::max(widest, planner.name.size());
    const auto row = [&](const std::string& name, const std::array<std::string, 6>& cells)
    {
        out << std::left << std::setw(static_cast<int>(widest)) << problems::printable(name) << std::right;
        for (const std::string& cell : cells)
            out << std::setw(kColumn) << cell;
        out << '\n';
    };
    out << problems::printable(experiment.name) << ", " << experiment.maxTime << " s a run; medians\n";
    row("planner", {"solved", "time", "length", "state checks", "accuracy", "coverage"});
    for (const auto& planner : experiment.planners)
    {
        const auto solved = std::ranges::count_if(planner.runs, &isSolved);
        const double time = median(planner.runs, "time REAL");
        row(planner.name, {concat(solved, " of ", planner.runs.size()), std::isnan(time) ? "-" : durationText(time),
                           numberText(median(planner.runs, "solution length REAL"), 2),
                           numberText(median(planner.runs, "state checks INTEGER"), 0),
                           numberText(median(planner.runs, "accuracy REAL"), 3),
                           numberText(median(planner.runs, "coverage REAL"), 3)});
    }
    if (!whole)
        out << "interrupted: runs completed before\n";
}

/// One property as "name TYPE" -> value, in JSON's types.
void addJson(nlohmann::ordered_json& json, const std::string& property, const std::string& value)
{
    const std::size_t blank = property.rfind(' ');
    std::string name = property.substr(0, blank);
    const std::string type = property.substr(blank + 1);
    std::ranges::replace(name, ' ', '_');
    double number = 0.0;
    if (type == "BOOLEAN")
        json[name] = value == "1";
    else if (type == "ENUM")
        json[name] = ob::PlannerStatus(static_cast<ob::PlannerStatus::StatusType>(std::stoi(value))).asString();
    else if (!problems::parse(value, number))
        json[name] = nullptr;
    else if (type == "INTEGER")
        json[name] = static_cast<std::int64_t>(number);
    else
        json[name] = number;
}

nlohmann::ordered_json toJson(const ompl::tools::Benchmark::CompleteExperiment& experiment, const CostsOfRuns& costs,
                              bool whole)
{
    nlohmann::ordered_json json{{"experiment", experiment.name},
                                {"time_limit_s", experiment.maxTime},
                                {"memory_limit_mb", experiment.maxMem},
                                {"runs_per_planner", experiment.runCount},
                                {"seed", experiment.seed},
                                {"complete", whole},
                                {"interrupted", !whole}};
    nlohmann::ordered_json& rows = json["results"] = nlohmann::ordered_json::array();
    for (const auto& planner : experiment.planners)
        for (std::size_t i = 0; i < planner.runs.size(); ++i)
        {
            nlohmann::ordered_json& row = rows.emplace_back();
            row["planner"] = planner.name;
            for (const auto& [property, value] : planner.runs[i])
                addJson(row, property, value);
            nlohmann::ordered_json& falling = row["costs"] = nlohmann::ordered_json::array();
            for (const Convergence::Point& point : costs.at(planner.name)[i])
                falling.push_back({point.time, point.cost});
        }
    return json;
}

ompl::tools::Benchmark::Request makeRequest(const BenchmarkOptions& options, const BenchmarkWishes& wishes)
{
    ompl::tools::Benchmark::Request request;
    request.maxTime = options.timeLimit ? std::chrono::duration<double>(*options.timeLimit).count()
                                        : wishes.timeLimit.value_or(kTimeLimit);
    request.maxMem = options.memoryLimit.value_or(wishes.memoryLimit.value_or(kMemoryLimit));
    request.runCount = options.runs.value_or(wishes.runCount.value_or(kRuns));
    request.displayProgress = false;
    request.saveConsoleOutput = false;
    request.simplify = options.simplify;
    return request;
}
}  // namespace

int benchmark(const BenchmarkOptions& options, std::ostream& out)
{
    ProblemOptions source;
    source.validityResolution = options.validityResolution;
    const std::unique_ptr<Problem> problem = readProblem(options.file, source);
    const BenchmarkWishes wishes = problem->benchmarkWishes();
    const std::vector<problems::PlannerRequest> requests =
        options.planners.empty() ? wishes.planners : parsePlanners(options.planners);
    if (requests.empty())
        throw InputError(options.file, 0, "expected planners: --planners NAME,... or a section [planner] in the file");
    const std::vector<Output> outputs{{"--log", options.logFile}};
    requireOutputs(outputs, problem->inputs(), options.json);

    const auto setup = problem->makeSetup(options.check);
    const ob::SpaceInformationPtr& si = setup->getSpaceInformation();
    const auto checker = std::make_shared<CountingChecker>(si, si->getStateValidityChecker());
    setup->setStateValidityChecker(checker);
    KeepingBenchmark benchmark(*setup, wishes.experiment.empty() ? problem->name() : wishes.experiment);
    addPlanners(benchmark, *problem, requests, si, checker);

    const auto request = makeRequest(options, wishes);
    CostsOfRuns costs;
    {
        const StopOnInterrupt stop;
        SeriesProgress progress("run", "runs", requests.size() * request.runCount);
        benchmark.setPreRunEvent([&progress](const ob::PlannerPtr& planner)
                                 { progress.begin(problems::printable(planner->getName())); });
        benchmark.setPostRunEvent(
            [&costs](const ob::PlannerPtr& planner, RunProperties& run)
            {
                if (interrupted())
                    throw Interrupt();  // this run is not a whole one
                const auto& wrapped = dynamic_cast<const InterruptiblePlanner&>(*planner);
                run["state checks INTEGER"] = std::to_string(wrapped.checks());
                addConvergence(run, wrapped.convergence().points());
                costs["geometric_" + planner->getName()].push_back(wrapped.convergence().points());
                if (planner->getProblemDefinition()->hasExactSolution())
                    run["valid at finer resolution BOOLEAN"] = holdsAtFinerResolution(*planner->getProblemDefinition());
                if (const auto* ours = dynamic_cast<const SpeculativeAStar*>(&wrapped.inner()))
                    addReport(run, ours->getReport());
            });
        benchmark.run(request);
    }

    const auto& experiment = benchmark.getRecordedExperimentData();
    if (!options.logFile.empty() && !experiment.planners.empty())
        writeOutput(options.logFile, [&](std::ostream& file) { benchmark.saveResultsToStream(file); });
    if (options.json)
        out << jsonText(toJson(experiment, costs, !interrupted()));
    else
        printTable(streamForTables(outputs, out), experiment, !interrupted());
    if (interrupted())
        return kInterrupted;
    const bool solved = std::ranges::all_of(
        experiment.planners, [](const auto& planner) { return std::ranges::any_of(planner.runs, &isSolved); });
    return solved ? kSolved : kNotSolved;
}
}  // namespace specplan::command
