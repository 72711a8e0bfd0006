// SPDX-License-Identifier: BSD-3-Clause
#include "Run.h"

#include <csignal>

#include "Progress.h"

namespace specplan::command
{
namespace ob = ompl::base;

namespace
{
volatile std::sig_atomic_t interruptSignals = 0;

extern "C" void noteInterrupt(int)
{
    interruptSignals = 1;
    std::signal(SIGINT, SIG_DFL);
}

/// Settings of a grid search, with what the user has chosen.
PlannerSettings onGrid(const NamedProblem& problem, const CommonOptions& options, PlannerSettings settings)
{
    const PlannerSettings grid = problems::gridPlannerSettings(problem.cornerCutting);
    settings.spacing = grid.spacing;
    settings.anytime = grid.anytime;
    settings.objectiveInChecks = grid.objectiveInChecks;
    settings.connectivity = grid.connectivity;
    settings.cornerCutting = grid.cornerCutting;
    if (options.check.duration.count() > 0)
        settings.virtualCheckCost = std::chrono::duration<double>(options.check.duration).count();
    return settings;
}
}  // namespace

void stopOnInterrupt()
{
    std::signal(SIGINT, noteInterrupt);
}

bool interrupted()
{
    return interruptSignals != 0;
}

Run planOnce(const NamedProblem& problem, const CommonOptions& options, const PlannerSettings& settings, bool keepOrder)
{
    Run run;
    run.problem = problem.name;
    run.settings = onGrid(problem, options, settings);
    // On the virtual clock checks take no real time.
    const bool simulated = settings.executor == "virtual";
    run.setup = problems::makeGridSetup(problem.problem, problem.file, options.problem.cost,
                                        simulated ? problems::ArtificialCheck{} : options.check);
    run.planner = std::make_shared<SpeculativeAStar>(run.setup->getSpaceInformation(), run.settings);
    run.setup->setPlanner(run.planner);
    if (keepOrder)
        run.planner->setExpansionObserver([&run](const ob::State* state)
                                          { run.expanded.push_back(problems::cellOf(state)); });

    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    Progress progress(*run.planner, problem.name, settings);
    run.setup->solve(ob::PlannerTerminationCondition(
        [&]
        {
            progress.tick();
            return interrupted() || (options.timeLimit && Clock::now() - begin >= *options.timeLimit);
        }));
    run.planner->setExpansionObserver({});
    run.report = run.planner->getReport();
    if (run.solved())
        for (const ob::State* state : run.setup->getSolutionPath().getStates())
            run.path.push_back(problems::cellOf(state));
    return run;
}
}  // namespace specplan::command
