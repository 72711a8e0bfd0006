// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/LazyTree.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "RandomProblem.h"

namespace specplan::test
{
namespace
{
using lattice::CheckId;
using search::LazyTree;

constexpr std::size_t kAnyNumber = 1U << 30U;

/// A tree over one random problem, with its own lattice.
struct Fixture
{
    explicit Fixture(const RandomProblem& problem)
        : lattice(std::make_unique<lattice::GridNeighbourhood>(problem.box(), problem.steps())),
          heuristic(problem.heuristic(lattice)),
          tree(lattice, heuristic)
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
            EXPECT_TRUE(tree.repair(kAnyNumber));
            if (tree.nearestGoal() == lattice::kNoNode)
                return {};
        } while (!tree.findPath(edges));
        cells.push_back(cell(tree.nearestGoal()));
        for (const LazyTree::EdgeId edge : edges)
            cells.push_back(cell(tree.from(edge)));
        return cells;
    }

    lattice::Lattice lattice;
    lattice::GridHeuristic heuristic;
    LazyTree tree;
    std::vector<LazyTree::EdgeId> edges;
};

TEST(LazyTree, RepairAndTakingBackLeadToTheTreeMadeFromScratch)
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
            ASSERT_EQ(fresh.path(), path);
        }
    }
    EXPECT_GT(changes, 1000U);
}

TEST(LazyTree, AVerdictCostsFarLessThanTheTree)
{
    lattice::GridSteps steps;
    steps.cost = [](std::span<const lattice::Coordinate> offset) { return std::hypot(offset[0], offset[1]); };
    lattice::Lattice lattice(std::make_unique<lattice::GridNeighbourhood>(lattice::GridBox{{0, 0}, {399, 399}}, steps));
    lattice::GridHeuristic heuristic(lattice, {1.0, 1.0}, 2);
    heuristic.addGoal({{350.0, 200.0}, {}});
    LazyTree tree(lattice, heuristic);
    const auto node = [&lattice](lattice::Coordinate x, lattice::Coordinate y)
    {
        const lattice::Coordinate cell[] = {x, y};
        return lattice.node(cell);
    };
    tree.addGoal(node(350, 200));
    tree.addStart(node(10, 120));
    EXPECT_FALSE(tree.repair(100));  // in portions
    EXPECT_EQ(tree.expansions(), 100U);
    ASSERT_TRUE(tree.repair(kAnyNumber));
    const std::uint64_t whole = tree.expansions();
    EXPECT_GT(whole, 10000U);

    // Equally short paths abound: one closed cell is passed at little cost.
    std::vector<LazyTree::EdgeId> path;
    ASSERT_TRUE(tree.findPath(path));
    tree.enter(CheckId::ofState(tree.to(path[path.size() / 2])), false);
    ASSERT_TRUE(tree.repair(kAnyNumber));
    EXPECT_LT(tree.expansions() - whole, whole / 10);
}
}  // namespace
}  // namespace specplan::test
