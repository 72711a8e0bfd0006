// SPDX-License-Identifier: BSD-3-Clause
// The lazy search against an independent Dijkstra, and against itself: the same cost, and the same decisions and
// path for every executor and number of workers, whatever the checks' timing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

#include "RandomProblem.h"
#include "specplan/search/LazySearch.h"
#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::test
{
namespace
{
using lattice::CheckId;
using lattice::NodeId;
using search::Selector;

struct Configuration
{
    std::string name;
    std::unique_ptr<ProblemChecker> checker;
    std::unique_ptr<validity::Executor> executor;
};

struct LazyResult
{
    search::SearchStatus status;
    std::vector<Cell> path;
    double cost;
    std::uint64_t decisions;
    std::uint64_t orderHash;
    std::uint64_t checksUsed;
    std::uint64_t speculativeChecks;
};

double virtualCost(CheckId check, bool valid)
{
    const std::uint64_t draw = util::mix(check.isMotion() ? check.motion() : check.node(), check.isMotion() ? 1 : 0);
    return (valid ? 1.0 : 0.1) * static_cast<double>(1 + draw % 16);
}

/// The first is the serial one that the others are compared with.
std::vector<Configuration> allConfigurations()
{
    std::vector<Configuration> all;
    const auto add = [&all](const std::string& kind, unsigned workers)
    {
        auto checker = std::make_unique<ProblemChecker>(workers, kind == "threads");
        std::unique_ptr<validity::Executor> executor;
        if (kind == "inline")
            executor = std::make_unique<validity::InlineExecutor>(*checker);
        else if (kind == "virtual")
            executor = std::make_unique<validity::VirtualExecutor>(*checker, workers, virtualCost);
        else
            executor = std::make_unique<validity::ThreadPoolExecutor>(*checker, workers);
        all.push_back({kind + " workers=" + std::to_string(workers), std::move(checker), std::move(executor)});
    };
    add("inline", 1);
    for (const unsigned workers : {1U, 2U, 3U, 8U, 32U})
        add("virtual", workers);
    for (const unsigned workers : {1U, 2U, 4U, 8U, 32U})
        add("threads", workers);
    return all;
}

void expectCountsAddUp(const validity::CheckStatistics& counts)
{
    EXPECT_GE(counts.speculativeChecks, counts.speculativeUsed + counts.speculativeDropped);
    EXPECT_EQ(counts.checksUsed, counts.usedReady + counts.usedAfterWait + counts.usedInline);
    EXPECT_EQ(counts.checksRun, counts.demandedChecks + counts.speculativeChecks - counts.speculativeDropped);
}

LazyResult solve(const RandomProblem& problem, Configuration& configuration, Selector selector, double weight = 1.0)
{
    lattice::Lattice lattice(std::make_unique<lattice::GridNeighbourhood>(problem.box(), problem.steps()));
    const lattice::GridHeuristic heuristic = problem.heuristic(lattice);
    configuration.checker->open(problem, lattice);
    validity::Broker broker(*configuration.executor);
    broker.setWarmUp(0.0);  // most of these problems are small
    search::LazySearch search(lattice, heuristic, broker, weight);
    search.setSelector(selector);
    lattice.setGlances(true);
    search.setGlances([&lattice](const lattice::Lattice::Motion& motion)
                      { return util::hashCoordinates(lattice.coordinates(motion.from)) % 3 != 0; });
    broker.setSource(&search);
    const auto node = [&lattice](const Cell& cell)
    { return lattice.node(std::vector<lattice::Coordinate>(cell.begin(), cell.end()).data()); };
    for (const Cell& goal : problem.goals())
        search.addGoal(node(goal));
    for (const Cell& start : problem.starts())
    {
        broker.setVerdict(CheckId::ofState(node(start)), true);
        search.addStart(node(start));
    }
    std::uint64_t entered = 0;
    search.setObserver([&entered](CheckId, bool) { ++entered; });
    const search::SearchStatus status = search.run([] { return false; });
    broker.settle();
    configuration.checker->close();
    EXPECT_EQ(configuration.checker->violations(), 0);
    expectCountsAddUp(broker.statistics());
    EXPECT_EQ(broker.statistics().checksUsed, entered);

    LazyResult result{status,
                      {},
                      search.costToCome(search.reachedGoal()),
                      search.decisions(),
                      search.orderHash(),
                      broker.statistics().checksUsed,
                      broker.statistics().speculativeChecks};
    for (const NodeId step : search.pathTo(search.reachedGoal()))
    {
        const auto coordinates = lattice.coordinates(step);
        result.path.emplace_back(coordinates.begin(), coordinates.end());
    }
    return result;
}

CellSolution dijkstra(const RandomProblem& random)
{
    CellProblem problem = random.forReference();
    problem.heuristic = [](const Cell&) { return 0.0; };
    return referenceAStar(problem);
}

/// Walks along a path with the reference's own successors. \return its cost; fails where it is not valid.
double costOfValidPath(const RandomProblem& random, const std::vector<Cell>& path)
{
    const CellProblem problem = random.forReference();
    EXPECT_NE(std::find(problem.starts.begin(), problem.starts.end(), path.front()), problem.starts.end());
    EXPECT_TRUE(problem.goals.contains(path.back()));
    double cost = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        bool found = false;
        for (const auto& [next, step] : problem.successors(path[i - 1]))
            if (next == path[i])
            {
                found = true;
                cost += step;
            }
        EXPECT_TRUE(found);
        EXPECT_TRUE(problem.isStateValid(path[i]));
        EXPECT_TRUE(problem.isMotionValid(path[i - 1], path[i]));
    }
    return cost;
}

/// Expects a valid path that costs at most `weight` times what the reference found.
void expectWithin(double weight, const RandomProblem& problem, const CellSolution& reference, const LazyResult& result)
{
    if (reference.path.empty())
    {
        EXPECT_EQ(result.status, search::SearchStatus::Infeasible);
        EXPECT_TRUE(result.path.empty());
        return;
    }
    ASSERT_EQ(result.status, search::SearchStatus::Solved);
    ASSERT_FALSE(result.path.empty());
    EXPECT_NEAR(costOfValidPath(problem, result.path), result.cost, 1e-9);
    EXPECT_LE(result.cost, weight * reference.cost + 1e-9);
    EXPECT_GE(result.cost, reference.cost - 1e-9);
    EXPECT_GE(result.checksUsed, result.decisions);
}

void expectEqual(const LazyResult& result, const LazyResult& serial)
{
    EXPECT_EQ(result.status, serial.status);
    EXPECT_EQ(result.decisions, serial.decisions);
    EXPECT_EQ(result.orderHash, serial.orderHash);
    EXPECT_EQ(result.path, serial.path);
    EXPECT_EQ(result.cost, serial.cost);
    EXPECT_EQ(result.checksUsed, serial.checksUsed);
}

TEST(LazyEquality, EveryExecutorAndThreadCountDecidesTheSameAndTheCostIsDijkstras)
{
    std::vector<Configuration> configurations = allConfigurations();
    std::uint64_t solved = 0;
    std::map<std::string, std::uint64_t> ahead;  // checks run ahead, by configuration
    for (std::uint64_t seed = 1; seed <= problemCount(); ++seed)
    {
        const RandomProblem problem(seed);
        const CellSolution reference = dijkstra(problem);
        solved += reference.path.empty() ? 0 : 1;
        LazyResult serial;
        for (Configuration& configuration : configurations)
        {
            SCOPED_TRACE("problem " + std::to_string(seed) + ", " + configuration.name);
            const LazyResult result = solve(problem, configuration, Selector::LeastLikely);
            ahead[configuration.name] += result.speculativeChecks;
            if (&configuration == &configurations.front())
            {
                serial = result;
                expectWithin(1.0, problem, reference, serial);
            }
            else
                expectEqual(result, serial);
            if (HasFatalFailure() || HasNonfatalFailure())
                return;
        }
    }
    // The problems are a mixture, or the test would show little.
    EXPECT_GT(solved, problemCount() / 4);
    EXPECT_LT(solved, problemCount());
    for (const auto& [name, checks] : ahead)
        EXPECT_EQ(checks > 0, !name.starts_with("inline")) << name << ": " << checks;
    for (const Configuration& configuration : configurations)
        EXPECT_GT(configuration.checker->glances(), 0U) << configuration.name;
}

TEST(LazyEquality, EverySelectorFindsTheSameCost)
{
    std::vector<Configuration> configurations = allConfigurations();
    for (std::uint64_t seed = 1; seed <= problemCount() / 10; ++seed)
    {
        const RandomProblem problem(seed);
        const CellSolution reference = dijkstra(problem);
        for (const Selector selector :
             {Selector::LeastLikely, Selector::Forward, Selector::Backward, Selector::Alternate})
        {
            SCOPED_TRACE("problem " + std::to_string(seed) + ", selector " +
                         std::to_string(static_cast<int>(selector)));
            const LazyResult serial = solve(problem, configurations.front(), selector);
            expectWithin(1.0, problem, reference, serial);
            expectEqual(solve(problem, configurations[5], selector), serial);
            if (HasFatalFailure() || HasNonfatalFailure())
                return;
        }
    }
}
TEST(LazyEquality, WeightsBoundTheCostAndEveryExecutorDecidesTheSame)
{
    std::vector<Configuration> configurations = allConfigurations();
    std::map<double, std::uint64_t> longer;  // paths longer than the optimum, by weight
    for (std::uint64_t seed = 1; seed <= problemCount() / 4; ++seed)
    {
        const RandomProblem problem(seed);
        const CellSolution reference = dijkstra(problem);
        for (const double weight : {1.1, 2.0, 1000.0})
        {
            SCOPED_TRACE("problem " + std::to_string(seed) + ", weight " + std::to_string(weight));
            const LazyResult serial = solve(problem, configurations.front(), Selector::LeastLikely, weight);
            expectWithin(weight, problem, reference, serial);
            longer[weight] += serial.cost > reference.cost + 1e-9 ? 1 : 0;
            Configuration& other = configurations[1 + seed % (configurations.size() - 1)];
            expectEqual(solve(problem, other, Selector::LeastLikely, weight), serial);
            if (HasFatalFailure() || HasNonfatalFailure())
                return;
        }
    }
    EXPECT_GT(longer[2.0], 0U);
    EXPECT_GT(longer[1000.0], longer[1.1]);
}
}  // namespace
}  // namespace specplan::test
