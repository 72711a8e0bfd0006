// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/GridHeuristic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <queue>

#include "specplan/lattice/GridNeighbourhood.h"

namespace specplan::lattice
{
namespace
{
using Row = std::vector<Coordinate>;

struct Grid
{
    std::vector<double> spacing;
    unsigned connectivity;
    Coordinate size;  ///< cells of each axis
};

double lengthOf(std::span<const double> offset, const std::vector<double>& spacing)
{
    double squared = 0.0;
    for (std::size_t axis = 0; axis < offset.size(); ++axis)
        squared += offset[axis] * spacing[axis] * (offset[axis] * spacing[axis]);
    return std::sqrt(squared);
}

Lattice makeLattice(const Grid& grid)
{
    GridSteps steps;
    steps.connectivity = grid.connectivity;
    steps.cost = [spacing = grid.spacing](std::span<const Coordinate> offset)
    { return lengthOf(std::vector<double>(offset.begin(), offset.end()), spacing); };
    return Lattice(std::make_unique<GridNeighbourhood>(
        GridBox{Row(grid.spacing.size(), 0), Row(grid.spacing.size(), grid.size - 1)}, steps));
}

/// Path lengths from one node to all others, by Dijkstra's algorithm.
std::map<NodeId, double> distancesFrom(Lattice& lattice, NodeId start)
{
    std::map<NodeId, double> distances{{start, 0.0}};
    std::priority_queue<std::pair<double, NodeId>, std::vector<std::pair<double, NodeId>>, std::greater<>> open;
    open.push({0.0, start});
    Successors successors;
    while (!open.empty())
    {
        const auto [distance, node] = open.top();
        open.pop();
        if (distance > distances[node])
            continue;
        lattice.successors(node, successors);
        for (const Successors::Edge& edge : successors.edges)
        {
            const auto [place, isNew] = distances.try_emplace(edge.node, distance + edge.cost);
            if (!isNew && place->second <= distance + edge.cost)
                continue;
            place->second = distance + edge.cost;
            open.push({place->second, edge.node});
        }
    }
    return distances;
}

const Grid kGrids[] = {{{1.0, 1.0}, 2, 9},           {{1.0, 0.3}, 2, 9},           {{1.0, 1.0}, 1, 9},
                       {{0.7, 1.0, 1.9}, 3, 6},      {{1.0, 1.0, 1.0}, 2, 6},      {{1.0, 2.0, 3.0}, 1, 5},
                       {{1.0, 1.0, 0.5, 2.0}, 4, 4}, {{1.0, 0.5, 1.0, 1.0}, 2, 4}, {{2.0}, 1, 20}};

TEST(GridHeuristic, IsExactWithFullConnectivityAndNeverTooHigh)
{
    for (const Grid& grid : kGrids)
    {
        Lattice lattice = makeLattice(grid);
        const NodeId goal = lattice.node(Row(grid.spacing.size(), 1).data());
        GridHeuristic heuristic(lattice, grid.spacing, grid.connectivity);
        heuristic.addGoal({std::vector<double>(grid.spacing.size(), 1.0), {}});
        const bool exact = grid.connectivity == grid.spacing.size() || grid.connectivity == 1;
        for (const auto& [node, distance] : distancesFrom(lattice, goal))
        {
            ASSERT_LE(heuristic.estimate(node), distance + 1e-9);
            if (exact)
            {
                ASSERT_NEAR(heuristic.estimate(node), distance, 1e-9);
            }
        }
    }
}

TEST(GridHeuristic, IsConsistentForGoalsOffTheGrid)
{
    for (const Grid& grid : kGrids)
    {
        Lattice lattice = makeLattice(grid);
        // The goal lies inside a cell and is joined to all of its corners.
        const std::vector<double> position(grid.spacing.size(), 1.3);
        const NodeId goal = lattice.addTerminal();
        GridHeuristic::Goal target{position, {}};
        for (unsigned corner = 0; corner < 1U << grid.spacing.size(); ++corner)
        {
            Row coordinates;
            std::vector<double> offset;
            for (std::size_t axis = 0; axis < grid.spacing.size(); ++axis)
            {
                coordinates.push_back(static_cast<Coordinate>(1 + (corner >> axis & 1U)));
                offset.push_back(position[axis] - coordinates.back());
            }
            lattice.connect(lattice.node(coordinates.data()), goal, lengthOf(offset, grid.spacing));
            target.approaches.push_back(offset);
        }
        GridHeuristic heuristic(lattice, grid.spacing, grid.connectivity);
        heuristic.addGoal(target);
        EXPECT_EQ(heuristic.estimate(goal), 0.0);
        Successors successors;
        const auto reached = distancesFrom(lattice, lattice.node(Row(grid.spacing.size(), 0).data()));
        for (const auto& [node, unused] : reached)
        {
            lattice.successors(node, successors);
            for (const Successors::Edge& edge : successors.edges)
                ASSERT_LE(heuristic.estimate(node), edge.cost + heuristic.estimate(edge.node) + 1e-9);
        }
    }
}

TEST(GridHeuristic, TakesTheNearestGoalAndNoneIsZero)
{
    Lattice lattice = makeLattice({{1.0, 1.0}, 2, 9});
    GridHeuristic heuristic(lattice, {1.0, 1.0}, 2);
    const NodeId node = lattice.node(Row{0, 0}.data());
    EXPECT_EQ(heuristic.estimate(node), 0.0);
    heuristic.addGoal({{8.0, 8.0}, {}});
    EXPECT_NEAR(heuristic.estimate(node), 8.0 * std::sqrt(2.0), 1e-12);
    heuristic.addGoal({{3.0, 0.0}, {}});
    EXPECT_NEAR(heuristic.estimate(node), 3.0, 1e-12);
}
}  // namespace
}  // namespace specplan::lattice
