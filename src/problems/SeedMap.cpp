// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/SeedMap.h"

#include <utility>

#include "specplan/problems/TextFile.h"

namespace specplan::problems
{
namespace
{
void readHeading(LineReader& in, const std::string& heading)
{
    if (const std::string line = in.expect("'", heading, "'"); line != heading)
        in.fail("expected '", heading, "', found ", inQuotes(line));
}

GridCell parsePair(const LineReader& in, const std::string& line, const std::string& what)
{
    const auto parts = split(line, ", ");
    GridCell pair{};
    if (parts.size() != 2 || !parse(parts[0], pair[0]) || !parse(parts[1], pair[1]))
        in.fail("expected ", what, " as two whole numbers 'a,b', found ", inQuotes(line));
    return pair;
}

GridCell parseCell(const LineReader& in, const std::string& line, const std::string& what, const GridCell& size)
{
    const GridCell pair = parsePair(in, line, what);
    if (pair[0] < 1 || pair[0] > size[0] || pair[1] < 1 || pair[1] > size[1])
        in.fail("expected ", what, " inside the map, 1,1 to ", size[0], ",", size[1], ", found ", inQuotes(line));
    return {pair[0] - 1, pair[1] - 1};
}

void readCosts(LineReader& in, GridMap& map, double threshold)
{
    for (int x = 0; x < map.width(); ++x)
    {
        const std::string line = in.expect("line ", x + 1, " of ", map.width(), " of M");
        const auto costs = split(line, ", ");
        if (costs.size() != static_cast<std::size_t>(map.height()))
            in.fail("expected ", map.height(), " costs, found ", costs.size());
        for (int y = 0; y < map.height(); ++y)
        {
            double cost = 0.0;
            if (!parse(costs[static_cast<std::size_t>(y)], cost))
                in.fail("expected a number, found ", inQuotes(costs[static_cast<std::size_t>(y)]));
            map.setFree(x, y, cost < threshold);
        }
    }
}
}  // namespace

GridProblem readSeedMap(const std::string& path)
{
    return parseSeedMap(readText(path), path);
}

GridProblem parseSeedMap(std::string text, const std::string& name)
{
    LineReader in(std::move(text), name);
    readHeading(in, "N");
    const GridCell size = parsePair(in, in.expect("the size of the map"), "the size of the map");
    if (size[0] < 1 || size[1] < 1 || static_cast<double>(size[0]) * size[1] > GridMap::kMaxCells)
        in.fail("expected a size of 1 to 2^28 cells");
    readHeading(in, "C");
    double threshold = 0.0;
    if (const std::string line = in.expect("the collision threshold"); !parse(line, threshold))
        in.fail("expected the collision threshold, a number, found ", inQuotes(line));
    readHeading(in, "R");
    const GridCell start = parseCell(in, in.expect("the robot's cell"), "the robot's cell", size);
    readHeading(in, "T");
    const GridCell goal = parseCell(in, in.expect("the target's cell"), "the target's cell", size);
    while (in.expect("'M'") != "M")
    {
        // further cells of a moving target
    }
    GridProblem problem{GridMap(size[0], size[1]), start, goal};
    readCosts(in, problem.map, threshold);
    return problem;
}

bool looksLikeSeedMap(std::string_view text)
{
    return text.starts_with("N\n") || text.starts_with("N\r\n") || text == "N";
}
}  // namespace specplan::problems
