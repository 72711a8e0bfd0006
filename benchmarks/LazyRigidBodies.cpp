// SPDX-License-Identifier: BSD-3-Clause
// What lazy evaluation saves on rigid bodies, for the problems named on the command line: checks of states and motions,
// time on the processor, and costs of A*, of the lazy A* that the lazy search is compared with, and of the lazy search,
// one thread each, on the lattice that the planner chooses.
#include <array>
#include <ctime>
#include <exception>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <vector>

#include <ompl/base/goals/GoalState.h>

#include "LazyBaseline.h"
#include "specplan/planner/LatticeQuery.h"
#include "specplan/problems/fcl/RigidBodySetup.h"
#include "specplan/validity/InlineExecutor.h"

namespace
{
namespace ob = ompl::base;
using namespace specplan;
using planner::LatticeQuery;
using validity::CheckId;

/// Counts the checks that it passes on.
class CountingChecker : public validity::Checker
{
public:
    explicit CountingChecker(planner::OmplChecker& checker) : checker_(checker)
    {
    }

    bool check(CheckId check, unsigned worker) override
    {
        ++(!check.isMotion() ? states : checker_.lattice().isGlance(check.motion()) ? glances : motions);
        const bool valid = checker_.check(check, worker);
        looks += checker_.statesOfLastCheck(worker);
        return valid;
    }

    std::uint64_t states = 0;
    std::uint64_t motions = 0;
    std::uint64_t glances = 0;
    std::uint64_t looks = 0;  ///< states looked at, those inside of motions included

private:
    planner::OmplChecker& checker_;
};

enum class Kind
{
    AStar,
    LazyAStar,
    Lazy
};

struct Row
{
    std::uint64_t states;
    std::uint64_t motions;
    std::uint64_t glances;
    std::uint64_t looks;
    double seconds;  ///< on the processor
    double cost;
};

Row solve(const problems::RigidBodySetup& problem, Kind kind, double weight)
{
    const auto setup = problem.makeSetup();
    const ob::SpaceInformationPtr& si = setup->getSpaceInformation();
    si->setup();
    PlannerSettings settings;
    settings.evaluation = kind == Kind::Lazy ? "lazy" : "eager";
    planner::OmplChecker checker(*si, 1);
    CountingChecker counting(checker);
    validity::InlineExecutor executor(counting);
    const ob::State* start = setup->getProblemDefinition()->getStartState(0);
    const ob::State* goal = setup->getGoal()->as<ob::GoalState>()->getState();
    LatticeQuery query(*si, setup->getOptimizationObjective(), settings, {}, executor, checker,
                       {{si->getStateValidityChecker()}, {si->getMotionValidator()}}, start, false);
    query.addStart(start);
    query.setGoal(setup->getGoal(), false);
    query.addGoal(goal);

    const std::clock_t before = std::clock();
    double cost = 0.0;
    if (kind == Kind::LazyAStar)
        cost = benchmarks::lazyAStar(query.lattice(), query.heuristic(), counting, query.starts().front(),
                                     query.goals().front(), weight)
                   .cost;
    else
    {
        query.beginSearch(weight);
        if (query.search().run([] { return false; }) != search::SearchStatus::Solved)
            throw std::runtime_error(problem.problem().name + ": no path on the lattice");
        cost = query.costToCome(query.search().reachedGoal()).value();
    }
    const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    return {counting.states, counting.motions, counting.glances, counting.looks, seconds, cost};
}

std::string text(const Row& row)
{
    std::ostringstream out;
    out << row.states << " + " << row.motions;
    if (row.glances > 0)
        out << " + " << row.glances;
    out << " (" << row.looks << "), " << std::setprecision(3) << row.seconds << " s";
    return out.str();
}

void measure(const std::string& file)
{
    const problems::RigidBodySetup problem(problems::readOmplAppProblem(file));
    for (const double weight : {1.0, 3.0})
    {
        const std::array rows{solve(problem, Kind::AStar, weight), solve(problem, Kind::LazyAStar, weight),
                              solve(problem, Kind::Lazy, weight)};
        std::cout << "| " << problem.problem().name << " | " << weight << " |";
        for (const Row& row : rows)
            std::cout << ' ' << text(row) << " |";
        for (const Row& row : rows)
            std::cout << ' ' << std::setprecision(6) << row.cost << (&row == &rows.back() ? " |" : ",");
        std::cout << std::endl;
    }
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc < 2)
    {
        std::cerr << "usage: specplan_bench_lazy_rigid_bodies PROBLEM.cfg...\n";
        return 2;
    }
    try
    {
        std::cout << "States + motions (+ glances) checked (states looked at in all), and time.\n\n"
                     "| problem | weight | A* | lazy A* | lazy | costs |\n|---|---|---|---|---|---|\n";
        for (int i = 1; i < argc; ++i)
            measure(argv[i]);
    }
    catch (const std::exception& error)
    {
        std::cerr << "specplan_bench_lazy_rigid_bodies: " << error.what() << '\n';
        return 2;
    }
    return 0;
}
