// SPDX-License-Identifier: BSD-3-Clause
#include "GoldenRuns.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Console.h>

#include "SpaceCases.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/problems/GridSetup.h"
#include "specplan/problems/MovingAi.h"
#if SPECPLAN_GOLDEN_RIGID_BODIES
#include "specplan/problems/OmplAppProblem.h"
#include "specplan/problems/fcl/RigidBodySetup.h"
#endif

namespace specplan::test
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
using Setup = std::shared_ptr<og::SimpleSetup>;
using Make = std::function<Setup()>;

const std::vector<std::string> kEvaluations{"eager", "lazy"};

/// Adds a run of a problem for each number of workers.
void add(std::vector<GoldenRun>& runs, const std::string& name, const Make& make, PlannerSettings settings,
         const std::vector<unsigned>& workers)
{
    settings.executor = "virtual";
    for (const unsigned count : workers)
    {
        settings.numThreads = count;
        std::ostringstream full;
        full << name << '/' << settings.evaluation << '/' << settings.speculationPolicy << '/' << count;
        if (settings.weight > 0.0)
            full << "/w" << settings.weight;
        runs.push_back({full.str(), make, settings});
    }
}

void addMaps(std::vector<GoldenRun>& runs, const std::string& scenes)
{
    for (const std::string map : {"city-64", "rooms-64", "maze-64", "random-64", "corridor-64"})
    {
        const std::string file = scenes + "/" + map + ".map";
        const Make make = [file]
        {
            const problems::ScenarioEntry entry = problems::readMovingAiScenario(file + ".scen").back();
            return problems::makeGridSetup({problems::readMovingAiMap(file), entry.start, entry.goal}, file,
                                           problems::GridCost::Length, {});
        };
        PlannerSettings settings = problems::gridPlannerSettings(true);
        for (const std::string& evaluation : kEvaluations)
        {
            settings.evaluation = evaluation;
            settings.weight = 1.0;
            for (const std::string policy : {"none", "direction", "runahead"})
            {
                settings.speculationPolicy = policy;
                add(runs, map, make, settings, {1, 8, 32, 128});
            }
            for (const double weight : {2.0, 1000.0})
            {
                settings.weight = weight;
                add(runs, map, make, settings, {1, 32});
            }
        }
    }
}

Setup setupOf(const SpaceCase& problem)
{
    auto setup = std::make_shared<og::SimpleSetup>(problem.make());
    const ob::StateSpacePtr space = setup->getStateSpace();
    setup->setStateValidityChecker(
        [space, &problem](const ob::State* state)
        {
            std::vector<double> reals;
            space->copyToReals(reals, state);
            return problem.clearance(reals) > 0.0;
        });
    setup->getSpaceInformation()->setStateValidityCheckingResolution(problem.validity);
    setup->getSpaceInformation()->setup();
    ob::ScopedState<> state(space);
    space->copyFromReals(state.get(), problem.start);
    setup->setStartState(state);
    const auto goals = std::make_shared<ob::GoalStates>(setup->getSpaceInformation());
    for (const std::vector<double>& goal : problem.goals)
    {
        space->copyFromReals(state.get(), goal);
        goals->addState(state);
    }
    setup->setGoal(goals);
    return setup;
}

void addSpaces(std::vector<GoldenRun>& runs)
{
    for (const SpaceCase& problem : spaceCases())
        for (const std::string& evaluation : kEvaluations)
        {
            PlannerSettings settings;
            settings.evaluation = evaluation;
            settings.resolution = problem.resolution;
            settings.anytime = false;
            add(runs, problem.name, [&problem] { return setupOf(problem); }, settings, {1, 8});
        }
}

/// A chain of links of equal length in the plane that has to get past two discs.
Setup makeArm(unsigned links)
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(links);
    space->setBounds(-2.5, 2.5);
    auto setup = std::make_shared<og::SimpleSetup>(space);
    setup->setStateValidityChecker(
        [links](const ob::State* state)
        {
            const double* joints = state->as<ob::RealVectorStateSpace::StateType>()->values;
            double x = 0.0;
            double y = 0.0;
            double angle = 0.0;
            for (unsigned i = 0; i < links; ++i)
            {
                angle += joints[i];
                x += std::cos(angle) / links;
                y += std::sin(angle) / links;
                if (std::hypot(x - 0.55, y - 0.5) < 0.18 || std::hypot(x + 0.4, y - 0.6) < 0.15)
                    return false;
            }
            return true;
        });
    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    for (unsigned i = 0; i < links; ++i)
    {
        start[i] = 0.0;
        goal[i] = i == 0 ? 1.3 : 0.05;
    }
    setup->setStartAndGoalStates(start, goal);
    return setup;
}

void addArms(std::vector<GoldenRun>& runs)
{
    for (const unsigned links : {3U, 5U, 6U})
        for (const std::string& evaluation : kEvaluations)
        {
            PlannerSettings settings;
            settings.evaluation = evaluation;
            settings.stopAtFirstPath = true;
            settings.weight = links > 4 ? 10.0 : 0.0;
            add(runs, "arm-" + std::to_string(links), [links] { return makeArm(links); }, settings, {1, 8, 32});
        }
}

void addRigidBodies(std::vector<GoldenRun>& runs, const std::string& scenes)
{
#if SPECPLAN_GOLDEN_RIGID_BODIES
    for (const std::string scene : {"office", "passage", "piano"})
    {
        const auto bodies = std::make_shared<const problems::RigidBodySetup>(
            problems::readOmplAppProblem(scenes + "/" + scene + ".cfg"));
        for (const std::string& evaluation : kEvaluations)
        {
            PlannerSettings settings;
            settings.evaluation = evaluation;
            settings.stopAtFirstPath = true;
            settings.weight = 3.0;
            add(runs, scene, [bodies] { return bodies->makeSetup(); }, settings, {1, 8, 128});
        }
    }
#else
    (void)runs;
    (void)scenes;
#endif
}
}  // namespace

std::vector<GoldenRun> goldenRuns(const std::string& scenes)
{
    std::vector<GoldenRun> runs;
    addMaps(runs, scenes);
    addSpaces(runs);
    addArms(runs);
    addRigidBodies(runs, scenes);
    return runs;
}

std::string resultOf(const GoldenRun& run)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const Setup setup = run.make();
    const auto planner = std::make_shared<SpeculativeAStar>(setup->getSpaceInformation(), run.settings);
    setup->setPlanner(planner);
    setup->setup();
    (void)planner->solve(ob::plannerNonTerminatingCondition());
    const SearchReport& report = planner->getReport();
    std::ostringstream line;
    line << run.name << ' ' << report.status << " order " << std::hex << report.orderHash << std::dec << " expansions "
         << report.expansions << " used " << report.checksUsed << " run " << report.checksTotal << " ahead "
         << report.speculativeChecks - report.speculativeDropped << std::setprecision(12) << " cost " << report.cost
         << " seconds " << report.virtualTime;
    return line.str();
}
}  // namespace specplan::test
