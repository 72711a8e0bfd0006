// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <vector>

namespace specplan::test
{
using Cell = std::vector<int>;

/// A planning problem on cells, as plain functions.
struct CellProblem
{
    std::vector<Cell> starts;
    std::set<Cell> goals;
    double weight;
    std::function<std::vector<std::pair<Cell, double>>(const Cell&)> successors;
    std::function<double(const Cell&)> heuristic;
    std::function<bool(const Cell&)> isStateValid;
    std::function<bool(const Cell&, const Cell&)> isMotionValid;
};

struct CellSolution
{
    std::vector<Cell> expansions;
    std::vector<Cell> path;  ///< empty if infeasible
    double cost = std::numeric_limits<double>::infinity();
    std::set<Cell> checkedStates;
};

/// Weighted A* as in the textbook: one thread, no cleverness, nothing shared with the library.
inline CellSolution referenceAStar(const CellProblem& problem)
{
    using Entry = std::tuple<double, double, long, Cell>;  // f, -g, age: the least comes first
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::map<Cell, double> g;
    std::map<Cell, Cell> parent;
    std::set<Cell> closed;
    CellSolution solution;
    long age = 0;
    for (const Cell& start : problem.starts)
        if (g.emplace(start, 0.0).second)
            open.emplace(problem.weight * problem.heuristic(start), 0.0, age++, start);
    while (!open.empty())
    {
        const auto [f, minusG, entryAge, cell] = open.top();
        open.pop();
        if (-minusG != g[cell] || !closed.insert(cell).second)
            continue;  // the old entry of an improved node
        solution.expansions.push_back(cell);
        if (problem.goals.contains(cell))
        {
            solution.cost = g[cell];
            for (Cell at = cell;; at = parent[at])
            {
                solution.path.insert(solution.path.begin(), at);
                if (!parent.contains(at))
                    return solution;
            }
        }
        for (const auto& [next, cost] : problem.successors(cell))
        {
            const double better = g[cell] + cost;
            if (closed.contains(next) || (g.contains(next) && !(better < g[next])))
                continue;
            solution.checkedStates.insert(next);
            if (!problem.isStateValid(next) || !problem.isMotionValid(cell, next))
                continue;
            g[next] = better;
            parent[next] = cell;
            open.emplace(better + problem.weight * problem.heuristic(next), -better, age++, next);
        }
    }
    return solution;
}
}  // namespace specplan::test
