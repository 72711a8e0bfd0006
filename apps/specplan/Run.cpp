// SPDX-License-Identifier: BSD-3-Clause
#include "Run.h"

#include <functional>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "Interrupt.h"
#include "Progress.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/PlannerCatalog.h"

namespace specplan::command
{
namespace ob = ompl::base;
using Clock = std::chrono::steady_clock;

namespace
{
constexpr std::chrono::seconds kTimeForOthers{10};

PlannerSettings settled(const Problem& problem, const CommonOptions& options, const PlannerSettings& chosen)
{
    PlannerSettings settings = problem.settle(chosen);
    settings.anytime = settings.anytime || options.anytime;
    settings.stopAtFirstPath = !options.anytime;
    return settings;
}

/// When a search that begins now has to end: the user's limit, or else that of the problem's file.
Clock::time_point endOfTime(const Problem& problem, const CommonOptions& options)
{
    const std::optional<double> wish = problem.benchmarkWishes().timeLimit;
    if (options.timeLimit)
        return Clock::now() + *options.timeLimit;
    if (wish)
        return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*wish));
    return Clock::time_point::max();
}

/// Notes each path that is better than those before, and when it was found.
void noteImprovements(Run& run)
{
    const Clock::time_point begin = Clock::now();
    run.setup->getProblemDefinition()->setIntermediateSolutionCallback(
        [&run, begin](const ob::Planner*, const std::vector<const ob::State*>&, ob::Cost cost)
        {
            const std::chrono::duration<double> sinceBegin = Clock::now() - begin;
            run.improvements.push_back({sinceBegin.count(), cost.value()});
        });
}

/// Notes the states that are expanded. The run must stay where it is.
void noteExpansions(Run& run, const Watch& watch)
{
    run.planner->setExpansionObserver(
        [&run, states = watch.states, order = watch.order,
         reals = std::vector<double>()](const ob::State* state) mutable
        {
            run.setup->getStateSpace()->copyToReals(reals, state);
            if (states)
                run.expanded.push_back(reals);
            if (order)
                run.order.push_back(std::hash<std::string_view>()(
                    {reinterpret_cast<const char*>(reals.data()), reals.size() * sizeof(double)}));
        });
}

void notePath(Run& run)
{
    const ob::StateSpace& space = *run.setup->getStateSpace();
    for (const ob::State* state : run.setup->getSolutionPath().getStates())
        space.copyToReals(run.path.emplace_back(), state);
}

/// What SpeculativeAStar's report would call it.
std::string nameOf(ob::PlannerStatus::StatusType status)
{
    for (const auto& [known, name] : {std::pair{ob::PlannerStatus::EXACT_SOLUTION, "solved"},
                                      {ob::PlannerStatus::INVALID_START, "invalid start"},
                                      {ob::PlannerStatus::INVALID_GOAL, "invalid goal"},
                                      {ob::PlannerStatus::CRASH, "crash"}})
        if (status == known)
            return name;
    return "timeout";
}

/// Who asks to stop should not read that the time was up.
void noteInterrupt(Run& run)
{
    run.interrupted = interrupted();
    if (run.interrupted && run.report.status == "timeout")
        run.report.status = "interrupted";
}
}  // namespace

Run planOnce(const Problem& problem, const CommonOptions& options, const PlannerSettings& settings, const Watch& watch)
{
    Run run;
    run.problem = problem.name();
    run.settings = settled(problem, options, settings);
    if (options.check.duration.count() > 0)
        run.settings.virtualCheckCost = std::chrono::duration<double>(options.check.duration).count();
    // On the virtual clock checks take no real time, unless they have to be measured.
    const bool simulated = settings.executor == "virtual" && !watch.trace;
    run.setup = problem.makeSetup(simulated ? problems::ArtificialCheck{} : options.check);
    run.planner = std::make_shared<SpeculativeAStar>(run.setup->getSpaceInformation(), run.settings);
    run.setup->setPlanner(run.planner);
    run.planner->setCheckTrace(watch.trace);
    if (watch.states || watch.order)
        noteExpansions(run, watch);

    if (options.anytime)
        noteImprovements(run);
    const Clock::time_point end = endOfTime(problem, options);
    Progress progress(*run.planner, problem.name(), settings);
    run.setup->solve(ob::PlannerTerminationCondition(
        [&]
        {
            progress.tick();
            const bool enough = watch.expansions && run.order.size() >= *watch.expansions;
            run.stopped = enough || interrupted() || Clock::now() >= end;
            return run.stopped;
        }));
    run.planner->setExpansionObserver({});
    run.setup->getProblemDefinition()->setIntermediateSolutionCallback({});
    run.report = run.planner->getReport();
    noteInterrupt(run);
    if (run.solved())
        notePath(run);
    return run;
}

void compare(Run& run, const Run& baseline)
{
    run.report.sequentialTime = baseline.seconds();
    run.report.speedup = run.seconds() > 0.0 ? baseline.seconds() / run.seconds() : 1.0;
    run.report.efficiency = run.report.speedup / run.report.threads;
    if (!run.stopped && !baseline.stopped && run.report.orderHash != baseline.report.orderHash)
        throw std::logic_error(problems::concat(run.problem, ": ", run.settings.speculationPolicy, " with ",
                                                run.report.threads,
                                                " threads expanded other states than sequential "
                                                "A*; please report this"));
}

void explain(const Problem& problem, const CommonOptions& options, std::ostream& out)
{
    const auto setup = problem.makeSetup({});
    const auto planner =
        std::make_shared<SpeculativeAStar>(setup->getSpaceInformation(), settled(problem, options, options.planner));
    setup->setPlanner(planner);
    setup->setup();
    planner->explain(out);
}

Run planOnceWith(const Problem& problem, const CommonOptions& options, const problems::PlannerRequest& request)
{
    Run run;
    run.problem = problem.name();
    run.setup = problem.makeSetup(options.check);
    const ob::PlannerPtr planner =
        problems::makePlanner(request.name, request.parameters, run.setup->getSpaceInformation());
    run.plannerName = planner->getName();
    run.setup->setPlanner(planner);

    const Clock::time_point begin = Clock::now();
    const Clock::time_point end = begin + options.timeLimit.value_or(kTimeForOthers);
    const ob::PlannerStatus status =
        run.setup->solve(ob::PlannerTerminationCondition([end] { return interrupted() || Clock::now() >= end; }));
    run.report.wallTime = std::chrono::duration<double>(Clock::now() - begin).count();
    run.report.cost = std::numeric_limits<double>::quiet_NaN();
    run.report.status = nameOf(status);
    noteInterrupt(run);
    if (!run.solved())
        return run;
    run.report.cost = run.setup->getSolutionPath().cost(run.setup->getOptimizationObjective()).value();
    notePath(run);
    return run;
}
}  // namespace specplan::command
