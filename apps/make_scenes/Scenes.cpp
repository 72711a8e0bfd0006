// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>

namespace specplan::make_scenes
{
using problems::GridCell;
using problems::GridMap;

namespace
{
/// Random whole numbers that are the same everywhere, which those of the standard's distributions are not.
class Dice
{
public:
    explicit Dice(int seed) : engine_(static_cast<std::uint64_t>(seed))
    {
    }

    /// \return low to high, both included.
    int between(int low, int high)
    {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }

    bool oneIn(int n)
    {
        return between(1, n) == 1;
    }

private:
    std::mt19937_64 engine_;
};

/// Sets all cells of a rectangle that lie inside the map; both corners belong to it.
void fill(GridMap& map, GridCell from, GridCell to, bool free)
{
    for (int y = std::max(from[1], 0); y <= std::min(to[1], map.height() - 1); ++y)
        for (int x = std::max(from[0], 0); x <= std::min(to[0], map.width() - 1); ++x)
            map.setFree(x, y, free);
}

GridMap allFree(int width, int height)
{
    GridMap map(width, height);
    fill(map, {0, 0}, {width - 1, height - 1}, true);
    return map;
}

/// Places of walls across a map, the outer ones included.
std::vector<int> makeCuts(Dice& dice, int size, int least, int most)
{
    std::vector<int> cuts{0};
    while (size - 1 - cuts.back() > 2 * most)
        cuts.push_back(cuts.back() + dice.between(least, most));
    if (size - 1 - cuts.back() > most)
        cuts.push_back((cuts.back() + size - 1) / 2);
    cuts.push_back(size - 1);
    return cuts;
}

/// A building between streets; large ones may have a courtyard with a way in.
void build(Dice& dice, GridMap& map, GridCell from, GridCell to)
{
    fill(map, from, to, false);
    const int width = to[0] - from[0];
    const int height = to[1] - from[1];
    if (width < 9 || height < 9 || dice.oneIn(3))
        return;
    const int wall = dice.between(2, 3);
    fill(map, {from[0] + wall, from[1] + wall}, {to[0] - wall, to[1] - wall}, true);
    const int door = dice.between(from[0] + wall, to[0] - wall - 1);
    const bool north = dice.oneIn(2);
    fill(map, {door, north ? from[1] : to[1] - wall}, {door + 1, north ? from[1] + wall : to[1]}, true);
}
}  // namespace

GridMap makeRooms(int size)
{
    Dice dice(size);
    GridMap map = allFree(size, size);
    const std::vector<int> columns = makeCuts(dice, size, size / 12 + 4, size / 6 + 4);
    const std::vector<int> rows = makeCuts(dice, size, size / 12 + 4, size / 6 + 4);
    for (const int x : columns)
        fill(map, {x, 0}, {x, size - 1}, false);
    for (const int y : rows)
        fill(map, {0, y}, {size - 1, y}, false);
    for (std::size_t i = 0; i + 1 < columns.size(); ++i)
        for (std::size_t j = 0; j + 1 < rows.size(); ++j)
        {
            if (i + 2 < columns.size() && !dice.oneIn(4))
            {
                const int door = dice.between(rows[j] + 1, rows[j + 1] - 2);
                fill(map, {columns[i + 1], door}, {columns[i + 1], door + 1}, true);
            }
            if (j + 2 < rows.size() && !dice.oneIn(4))
            {
                const int door = dice.between(columns[i] + 1, columns[i + 1] - 2);
                fill(map, {door, rows[j + 1]}, {door + 1, rows[j + 1]}, true);
            }
        }
    return map;
}

GridMap makeMaze(int size)
{
    constexpr int kPitch = 4;  // three free cells and a wall
    const int cells = (size - 1) / kPitch;
    Dice dice(size);
    GridMap map(size, size);
    const auto open = [&map](GridCell a, GridCell b)
    {
        const GridCell low{std::min(a[0], b[0]) * kPitch + 1, std::min(a[1], b[1]) * kPitch + 1};
        const GridCell high{std::max(a[0], b[0]) * kPitch + 3, std::max(a[1], b[1]) * kPitch + 3};
        fill(map, low, high, true);
    };
    constexpr std::array<GridCell, 4> kAround{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto inside = [cells](GridCell c) { return c[0] >= 0 && c[1] >= 0 && c[0] < cells && c[1] < cells; };

    // Depth first, always on to a random neighbour that was not visited.
    std::vector<bool> visited(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    const auto mark = [&visited, cells](GridCell c) {
        return visited[static_cast<std::size_t>(c[1]) * static_cast<std::size_t>(cells) +
                       static_cast<std::size_t>(c[0])];
    };
    std::vector<GridCell> trail{{0, 0}};
    mark({0, 0}) = true;
    while (!trail.empty())
    {
        const GridCell here = trail.back();
        std::vector<GridCell> choices;
        for (const GridCell& step : kAround)
            if (const GridCell next{here[0] + step[0], here[1] + step[1]}; inside(next) && !mark(next))
                choices.push_back(next);
        if (choices.empty())
        {
            trail.pop_back();
            continue;
        }
        const GridCell next = choices[static_cast<std::size_t>(dice.between(0, static_cast<int>(choices.size()) - 1))];
        mark(next) = true;
        open(here, next);
        trail.push_back(next);
    }
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            if (const GridCell next{x + 1, y}; inside(next) && dice.oneIn(12))
                open({x, y}, next);
    return map;
}

GridMap makeRandom(int size)
{
    Dice dice(size);
    GridMap map = allFree(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (dice.between(1, 10) <= 3)
                map.setFree(x, y, false);
    return map;
}

GridMap makeCity(int size)
{
    Dice dice(size);
    GridMap map = allFree(size, size);
    const std::vector<int> columns = makeCuts(dice, size, 8, 20);
    const std::vector<int> rows = makeCuts(dice, size, 8, 20);
    for (std::size_t i = 0; i + 1 < columns.size(); ++i)
        for (std::size_t j = 0; j + 1 < rows.size(); ++j)
        {
            if (dice.oneIn(9))
                continue;  // a square
            const GridCell from{columns[i] + dice.between(1, 2), rows[j] + dice.between(1, 2)};
            const GridCell to{columns[i + 1] - dice.between(1, 2), rows[j + 1] - dice.between(1, 2)};
            build(dice, map, from, to);
            // Some blocks touch: a street ends here.
            if (dice.oneIn(6))
                fill(map, {to[0] + 1, from[1]}, {columns[i + 1] + 2, from[1] + 2}, false);
            if (dice.oneIn(6))
                fill(map, {from[0], to[1] + 1}, {from[0] + 2, rows[j + 1] + 2}, false);
        }
    return map;
}

GridMap makeCorridor(int length)
{
    GridMap map(length, 9);
    fill(map, {1, 1}, {length - 2, 7}, true);
    return map;
}

std::vector<Scene> makeAllScenes()
{
    std::vector<Scene> scenes;
    const auto add = [&scenes](const std::string& name, int size, GridMap map) {
        scenes.push_back({name + "-" + std::to_string(size) + ".map", std::move(map)});
    };
    for (const int size : {64, 128, 256})
    {
        add("rooms", size, makeRooms(size));
        add("maze", size, makeMaze(size));
        add("random", size, makeRandom(size));
        add("city", size, makeCity(size));
        add("corridor", size, makeCorridor(size));
    }
    return scenes;
}
}  // namespace specplan::make_scenes
