// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/LazyTree.h"

#include <gtest/gtest.h>

#include <set>

#include <deque>
#include <random>

#include "RandomProblem.h"

namespace specplan::test
{
namespace
{
using lattice::CheckId;
using search::LazyTree;
using Repair = LazyTree::Repair;

constexpr std::size_t kAnyNumber = 1U << 30U;

/// A tree over one random problem, with its own lattice.
struct Fixture
{
    explicit Fixture(const RandomProblem& problem, double weight = 1.0)
        : lattice(std::make_unique<lattice::GridNeighbourhood>(problem.box(), problem.steps())),
          heuristic(problem.heuristic(lattice)),
          tree(lattice, heuristic, weight)
    {
        for (const Cell& goal : problem.goals())
            tree.addGoal(node(goal));
        for (const Cell& start : problem.starts())
            tree.addStart(node(start));
    }

    lattice::NodeId node(const Cell& cell)
    {
        return lattice.node(std::vector<lattice::Coordinate>(cell.begin(), cell.end()).data());
    }

    Cell cell(lattice::NodeId id) const
    {
        const auto at = lattice.coordinates(id);
        return {at.begin(), at.end()};
    }

    /// Nodes of the best path, goal first; empty if there is none.
    std::vector<Cell> path()
    {
        std::vector<Cell> cells;
        do
        {
            EXPECT_EQ(tree.repair(kAnyNumber), Repair::Done);
            if (tree.nearestGoal() == lattice::kNoNode)
                return {};
        } while (!tree.findPath(edges));
        cells.push_back(cell(tree.nearestGoal()));
        for (const LazyTree::EdgeId edge : edges)
            cells.push_back(cell(tree.from(edge)));
        return cells;
    }

    /// Length of the path found last.
    double cost()
    {
        double sum = 0.0;
        lattice::Successors successors;
        for (const LazyTree::EdgeId edge : edges)
        {
            lattice.successors(tree.from(edge), successors);
            sum += successors.edges[tree.indexOf(edge)].cost;
        }
        return sum;
    }

    lattice::Lattice lattice;
    lattice::GridHeuristic heuristic;
    LazyTree tree;
    std::vector<LazyTree::EdgeId> edges;
};

TEST(LazyTree, RepairAndTakingBackLeadToTheCostFoundFromScratch)
{
    std::uint64_t changes = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        SCOPED_TRACE("problem " + std::to_string(seed));
        const RandomProblem problem(seed);
        std::mt19937_64 random(seed);
        Fixture repaired(problem);
        std::vector<Cell> closed;
        std::vector<Cell> path = repaired.path();
        for (int step = 0; step < 12 && path.size() > 2; ++step)
        {
            // Close some cells of the path one after another as a trial, take all of it back, and close one for good.
            std::deque<std::pair<Cell, LazyTree::Journal>> trials;
            std::vector<Cell> trial = path;
            for (int i = 0; i < 3 && trial.size() > 2; ++i)
            {
                const Cell cell = trial[1 + random() % (trial.size() - 2)];
                trials.emplace_back(cell, LazyTree::Journal{});
                repaired.tree.record(&trials.back().second);
                repaired.tree.enter(CheckId::ofState(repaired.node(cell)), false);
                trial = repaired.path();
            }
            repaired.tree.record(nullptr);
            for (; !trials.empty(); trials.pop_back())
            {
                changes += trials.back().second.size();
                repaired.tree.undo(CheckId::ofState(repaired.node(trials.back().first)), trials.back().second);
            }
            EXPECT_EQ(repaired.path(), path);

            closed.push_back(path[1 + random() % (path.size() - 2)]);
            repaired.tree.enter(CheckId::ofState(repaired.node(closed.back())), false);
            path = repaired.path();

            Fixture fresh(problem);
            for (const Cell& cell : closed)
                fresh.tree.enter(CheckId::ofState(fresh.node(cell)), false);
            ASSERT_EQ(fresh.path().empty(), path.empty());
            if (!path.empty())
            {
                ASSERT_NEAR(fresh.cost(), repaired.cost(), 1e-9);
            }
        }
    }
    EXPECT_GT(changes, 1000U);
}

/// A square of 400 x 400 cells with a way from left to right.
struct Square
{
    Square() : lattice(std::make_unique<lattice::GridNeighbourhood>(lattice::GridBox{{0, 0}, {399, 399}}, steps()))
    {
        heuristic.addGoal({{350.0, 200.0}, {}});
        tree.addGoal(node(350, 200));
        tree.addStart(node(10, 120));
    }

    static lattice::GridSteps steps()
    {
        lattice::GridSteps steps;
        steps.cost = [](std::span<const lattice::Coordinate> offset) { return std::hypot(offset[0], offset[1]); };
        return steps;
    }

    lattice::NodeId node(lattice::Coordinate x, lattice::Coordinate y)
    {
        const lattice::Coordinate cell[] = {x, y};
        return lattice.node(cell);
    }

    lattice::Lattice lattice;
    lattice::GridHeuristic heuristic{lattice, {1.0, 1.0}, 2};
    LazyTree tree{lattice, heuristic};
    std::vector<LazyTree::EdgeId> path;
};

TEST(LazyTree, OfEquallyShortPathsOneIsFollowed)
{
    Square square;
    EXPECT_EQ(square.tree.repair(100), Repair::Unfinished);  // in portions
    EXPECT_EQ(square.tree.expansions(), 100U);
    ASSERT_EQ(square.tree.repair(kAnyNumber), Repair::Done);
    ASSERT_TRUE(square.tree.findPath(square.path));
    EXPECT_EQ(square.path.size(), 340U);
    EXPECT_EQ(square.tree.expansions(), 341U);
}

TEST(LazyTree, AVerdictCostsFarLessThanTheTree)
{
    Square square;
    for (lattice::Coordinate y = 0; y < 350; ++y)
        square.tree.enter(CheckId::ofState(square.node(200, y)), false);
    ASSERT_EQ(square.tree.repair(kAnyNumber), Repair::Done);
    const std::uint64_t whole = square.tree.expansions();
    EXPECT_GT(whole, 10000U);

    ASSERT_TRUE(square.tree.findPath(square.path));
    square.tree.enter(CheckId::ofState(square.tree.to(square.path[20])), false);
    ASSERT_EQ(square.tree.repair(kAnyNumber), Repair::Done);
    EXPECT_LT(square.tree.expansions() - whole, whole / 100);
}

std::vector<lattice::NodeId> doubtfulOf(Square& square, std::size_t count)
{
    std::vector<lattice::NodeId> doubtful;
    square.tree.doubtful(count, doubtful);
    return doubtful;
}

TEST(LazyTree, NamesWhatIsDoubtfulOnOpenOnceAndBeginsWhereItStands)
{
    Square square;
    square.tree.setDoubt([&square](lattice::NodeId node) { return square.lattice.coordinates(node)[0] >= 100; });
    for (int rounds = 0; rounds < 10; ++rounds)
    {
        ASSERT_EQ(square.tree.repair(kAnyNumber), Repair::Doubtful);
        const std::vector<lattice::NodeId> named = doubtfulOf(square, 1000);
        ASSERT_GE(named.size(), 2U);
        EXPECT_EQ(doubtfulOf(square, 1), std::vector{named.front()});
        EXPECT_EQ(std::set(named.begin(), named.end()).size(), named.size());
        for (const lattice::NodeId node : named)
        {
            EXPECT_FALSE(square.tree.isPassed(node));
            EXPECT_EQ(square.tree.verdict(CheckId::ofState(node)), validity::Verdict::Unknown);
            EXPECT_EQ(square.lattice.coordinates(node)[0], 100);
        }
        square.tree.enter(CheckId::ofState(named.front()), false);
    }
}

TEST(LazyTree, KnowsWhichNodesAWayLeadsThrough)
{
    Square square;
    ASSERT_EQ(square.tree.repair(kAnyNumber), Repair::Done);
    ASSERT_TRUE(square.tree.findPath(square.path));
    std::vector<lattice::NodeId> way{square.tree.nearestGoal()};  // goal first
    for (const LazyTree::EdgeId edge : square.path)
        way.push_back(square.tree.from(edge));
    const lattice::NodeId near = way[300];
    const lattice::NodeId far = way[200];
    const lattice::NodeId beside = square.node(100, 100);
    EXPECT_TRUE(square.tree.comesThrough(far, std::vector{near}));
    EXPECT_TRUE(square.tree.comesThrough(way.front(), std::vector{way.back(), far}));
    EXPECT_FALSE(square.tree.comesThrough(near, std::vector{near, far})) << "not through itself";
    EXPECT_FALSE(square.tree.comesThrough(way.front(), std::vector{beside}));
    EXPECT_FALSE(square.tree.comesThrough(far, {}));
    EXPECT_FALSE(square.tree.comesThrough(way.back(), std::vector{way.back()})) << "to the start there is no way";
}

TEST(LazyTree, WhatIsDoubtfulIsAskedForBeforeWaysAreBuiltOnIt)
{
    Square square;
    const lattice::NodeId doubtful = square.node(100, 120);  // on the one path that it would follow
    square.tree.setDoubt([doubtful](lattice::NodeId node) { return node == doubtful; });
    ASSERT_EQ(square.tree.repair(kAnyNumber), Repair::Doubtful);
    EXPECT_EQ(doubtfulOf(square, 1), std::vector{doubtful});
    EXPECT_FALSE(square.tree.isPassed(doubtful));
    EXPECT_TRUE(square.tree.isPassed(square.node(99, 120)));
    EXPECT_FALSE(square.tree.isPassed(square.node(101, 120)));
    square.tree.enter(CheckId::ofState(doubtful), true);
    ASSERT_EQ(square.tree.repair(kAnyNumber), Repair::Done);
    EXPECT_TRUE(square.tree.isPassed(doubtful));
    EXPECT_EQ(square.tree.expansions(), 341U);
}
}  // namespace
}  // namespace specplan::test
