// SPDX-License-Identifier: BSD-3-Clause
#include "Scenarios.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <random>
#include <utility>

namespace specplan::make_scenes
{
using problems::GridCell;
using problems::GridMap;
using problems::ScenarioEntry;

namespace
{
constexpr int kQueries = 10;
constexpr double kBucketLength = 4.0;  // as in the Moving AI Lab's scenarios

std::size_t indexOf(const GridMap& map, GridCell cell)
{
    return static_cast<std::size_t>(cell[1]) * static_cast<std::size_t>(map.width()) +
           static_cast<std::size_t>(cell[0]);
}

GridCell cellAt(const GridMap& map, std::size_t index)
{
    return {static_cast<int>(index % static_cast<std::size_t>(map.width())),
            static_cast<int>(index / static_cast<std::size_t>(map.width()))};
}

/// Reachable cell whose distance comes closest to `length`; the first of equals.
GridCell cellAtDistance(const GridMap& map, const std::vector<double>& distances, double length)
{
    std::size_t best = 0;
    double error = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < distances.size(); ++i)
        if (std::isfinite(distances[i]) && std::abs(distances[i] - length) < error)
        {
            error = std::abs(distances[i] - length);
            best = i;
        }
    return cellAt(map, best);
}

GridCell farthest(const GridMap& map, const std::vector<double>& distances)
{
    std::size_t best = 0;
    for (std::size_t i = 0; i < distances.size(); ++i)
        if (std::isfinite(distances[i]) && !(distances[best] >= distances[i] && std::isfinite(distances[best])))
            best = i;
    return cellAt(map, best);
}

ScenarioEntry makeEntry(const GridMap& map, const std::string& file, GridCell start, GridCell goal, double length)
{
    return {static_cast<int>(length / kBucketLength), file, map.width(), map.height(), start, goal, length};
}
}  // namespace

std::vector<double> distancesFrom(const GridMap& map, GridCell from)
{
    std::vector<double> distances(static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.height()),
                                  std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    distances[indexOf(map, from)] = 0.0;
    open.push({0.0, indexOf(map, from)});
    while (!open.empty())
    {
        const auto [distance, index] = open.top();
        open.pop();
        if (distance > distances[index])
            continue;
        const auto [x, y] = cellAt(map, index);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
            {
                if ((dx == 0 && dy == 0) || !map.isFree(x + dx, y + dy) || !map.isFree(x + dx, y) ||
                    !map.isFree(x, y + dy))
                    continue;
                const double length = distance + (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0);
                const std::size_t next = indexOf(map, {x + dx, y + dy});
                if (length >= distances[next])
                    continue;
                distances[next] = length;
                open.push({length, next});
            }
    }
    return distances;
}

std::vector<ScenarioEntry> makeScenario(const GridMap& map, const std::string& file)
{
    // Twice to the farthest cell comes near the longest query of all.
    std::mt19937_64 dice(indexOf(map, {map.width() - 1, map.height() - 1}));
    const auto somewhere = [&map, &dice]
    {
        for (;;)
            if (const GridCell cell = cellAt(map, dice() % (indexOf(map, {map.width() - 1, map.height() - 1}) + 1));
                map.isFree(cell[0], cell[1]))
                return cell;
    };
    std::vector<double> distances;
    double longest = 0.0;
    GridCell start{};
    GridCell goal{};
    while (longest < map.width() / 2.0)  // not from inside a closed yard
    {
        start = farthest(map, distancesFrom(map, somewhere()));
        distances = distancesFrom(map, start);
        goal = farthest(map, distances);
        longest = distances[indexOf(map, goal)];
    }
    const std::vector<double> fromStart = distances;
    std::vector<ScenarioEntry> entries;
    for (int i = 1; i < kQueries; ++i)
    {
        GridCell from = somewhere();
        while (!std::isfinite(fromStart[indexOf(map, from)]))
            from = somewhere();
        distances = distancesFrom(map, from);
        const GridCell to = cellAtDistance(map, distances, longest * i / kQueries);
        entries.push_back(makeEntry(map, file, from, to, distances[indexOf(map, to)]));
    }
    entries.push_back(makeEntry(map, file, start, goal, longest));
    return entries;
}
}  // namespace specplan::make_scenes
