// SPDX-License-Identifier: BSD-3-Clause
// Speculation is invisible: expansions, path and cost are those of a plain serial A* for every number of threads, every
// policy and every executor, whatever the checks' timing.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "RandomProblem.h"
#include "specplan/search/AStar.h"
#include "specplan/speculation/DirectionPolicy.h"
#include "specplan/speculation/HedgedPolicy.h"
#include "specplan/speculation/LearningPredictor.h"
#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::test
{
using lattice::CheckId;
using lattice::NodeId;

struct Configuration
{
    std::string name;
    std::string policy;
    bool barrier;
    std::unique_ptr<ProblemChecker> checker;
    std::unique_ptr<validity::Executor> executor;
};

/// Durations of checks on the virtual clock: different for each, the same in every run.
inline double virtualCost(CheckId check, bool valid)
{
    const std::uint64_t draw = util::mix(check.isMotion() ? check.motion() : check.node(), check.isMotion() ? 1 : 0);
    return (valid ? 1.0 : 0.1) * static_cast<double>(1 + draw % 16);
}

inline std::unique_ptr<validity::Executor> makeExecutor(const std::string& kind, unsigned workers,
                                                        ProblemChecker& checker)
{
    if (kind == "inline")
        return std::make_unique<validity::InlineExecutor>(checker);
    if (kind == "virtual")
        return std::make_unique<validity::VirtualExecutor>(checker, workers, virtualCost);
    return std::make_unique<validity::ThreadPoolExecutor>(checker, workers);
}

/// Every executor × number of workers × policy. Pools live as long as the test, as they do in a planner.
inline std::vector<Configuration> allConfigurations()
{
    std::vector<Configuration> all;
    for (const std::string kind : {"inline", "virtual", "threads"})
        for (const unsigned workers : {1U, 2U, 4U, 8U, 32U})
            for (const std::string policy :
                 {"none", "direction", "direction with barrier", "runahead optimistic", "runahead", "runahead hedged"})
            {
                if (kind == "inline" && (workers > 1 || policy != "none"))
                    continue;
                auto checker = std::make_unique<ProblemChecker>(workers, kind == "threads");
                std::unique_ptr<validity::Executor> executor = makeExecutor(kind, workers, *checker);
                all.push_back({kind + " workers=" + std::to_string(workers) + " " + policy, policy,
                               policy == "direction with barrier", std::move(checker), std::move(executor)});
            }
    return all;
}

inline std::unique_ptr<speculation::Policy> makePolicy(const std::string& name, lattice::Lattice& lattice,
                                                       const validity::Broker& broker, const search::AStar& search,
                                                       speculation::Predictor& predictor)
{
    if (name == "none")
        return nullptr;
    if (name == "runahead hedged")
        return std::make_unique<speculation::HedgedPolicy>(lattice, broker, search, predictor, 1.0);
    if (name.starts_with("runahead"))
        return std::make_unique<speculation::RunAheadPolicy>(lattice, broker, search, predictor, 1.0);
    return std::make_unique<speculation::DirectionPolicy>(lattice, broker, name == "direction" ? 4 : 1);
}

inline void expectCountsAddUp(const validity::CheckStatistics& counts)
{
    EXPECT_EQ(counts.speculativeChecks,
              counts.speculativeUsed + counts.speculativeWasted() + counts.speculativeDropped);
    EXPECT_GE(counts.speculativeChecks, counts.speculativeUsed + counts.speculativeDropped);
    EXPECT_EQ(counts.checksUsed, counts.usedReady + counts.usedAfterWait + counts.usedInline);
    EXPECT_EQ(counts.checksRun, counts.demandedChecks + counts.speculativeChecks - counts.speculativeDropped);
}

/// \return the number of checks that were run.
inline std::uint64_t expectSameSearch(const RandomProblem& problem, const CellSolution& reference,
                                      ProblemChecker& checker, Configuration& configuration)
{
    lattice::Lattice lattice(std::make_unique<lattice::GridNeighbourhood>(problem.box(), problem.steps()));
    const lattice::GridHeuristic heuristic = problem.heuristic(lattice);
    ProblemCosts costs(problem, lattice);
    if (problem.costs() != CostsBefore::Known)
        lattice.setMotionCosts(&costs);
    checker.open(problem, lattice);
    validity::Broker broker(*configuration.executor);
    broker.setWarmUp(0.0);  // most of these problems are small
    broker.setBarrier(configuration.barrier);
    search::AStar search(lattice, heuristic, broker, problem.weight());
    speculation::OptimisticPredictor optimist;
    speculation::LearningPredictor learning(lattice);
    speculation::Predictor& predictor =
        configuration.policy == "runahead optimistic" ? static_cast<speculation::Predictor&>(optimist) : learning;
    const auto policy = makePolicy(configuration.policy, lattice, broker, search, predictor);
    broker.setSource(policy.get());
    search.setPolicy(policy.get());
    std::vector<Cell> expansions;
    search.setObserver([&](NodeId node) { expansions.push_back(cellOf(lattice, node)); });
    const auto node = [&lattice](const Cell& cell)
    { return lattice.node(std::vector<lattice::Coordinate>(cell.begin(), cell.end()).data()); };
    for (const Cell& goal : problem.goals())
        search.addGoal(node(goal));
    for (const Cell& start : problem.starts())
    {
        broker.setVerdict(CheckId::ofState(node(start)), true);
        search.addStart(node(start));
    }

    const search::SearchStatus status = search.run([] { return false; });
    broker.settle();
    checker.close();

    EXPECT_EQ(expansions, reference.expansions);
    EXPECT_EQ(search.expansions(), reference.expansions.size());
    EXPECT_EQ(status, reference.path.empty() ? search::SearchStatus::Infeasible : search::SearchStatus::Solved);
    if (status == search::SearchStatus::Solved)
    {
        EXPECT_EQ(search.costToCome(search.reachedGoal()), reference.cost);
        std::vector<Cell> path;
        for (const NodeId step : search.pathTo(search.reachedGoal()))
            path.push_back(cellOf(lattice, step));
        EXPECT_EQ(path, reference.path);
    }
    EXPECT_EQ(checker.violations(), 0);
    expectCountsAddUp(broker.statistics());
    return broker.statistics().checksRun;
}

/// The configurations that solve a problem. Real threads wait for the machine, so they take turns: two of them at each
/// problem, all of them after 15. The others solve every problem.
inline std::vector<Configuration*> configurationsFor(std::uint64_t seed, std::vector<Configuration>& all)
{
    std::vector<Configuration*> chosen;
    std::vector<Configuration*> threaded;
    for (Configuration& configuration : all)
        (configuration.name.starts_with("threads") ? threaded : chosen).push_back(&configuration);
    const std::size_t half = threaded.size() / 2;
    chosen.push_back(threaded[seed % half]);
    chosen.push_back(threaded[half + seed % half]);
    return chosen;
}
}  // namespace specplan::test
