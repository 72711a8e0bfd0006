// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/MovingAi.h"

#include <iomanip>
#include <ostream>
#include <string_view>
#include <utility>

#include "specplan/problems/OutputFile.h"
#include "specplan/problems/TextFile.h"

namespace specplan::problems
{
namespace
{
constexpr std::string_view kFree = ".GS";
constexpr std::string_view kBlocked = "@OTW";

int readSize(LineReader& in, const std::string& name)
{
    const std::string expected = concat("'", name, " N' with N from 1");
    const std::string line = in.expect(expected);
    const auto parts = split(line, " \t");
    int size = 0;
    if (parts.size() != 2 || parts[0] != name || !parse(parts[1], size) || size < 1)
        in.fail("expected ", expected, ", found ", inQuotes(line));
    return size;
}

void readRow(LineReader& in, GridMap& map, int y)
{
    const std::string row = in.expect("row ", y + 1, " of ", map.height());
    if (row.size() != static_cast<std::size_t>(map.width()))
        in.fail("expected a row of ", map.width(), " cells, found ", row.size());
    for (int x = 0; x < map.width(); ++x)
    {
        const char cell = row[static_cast<std::size_t>(x)];
        if (kFree.find(cell) != std::string_view::npos)
            map.setFree(x, y, true);
        else if (kBlocked.find(cell) == std::string_view::npos)
            in.fail("expected one of . G S @ O T W, found ", inQuotes({&cell, 1}), " in column ", x + 1);
    }
}

ScenarioEntry readEntry(const LineReader& in, const std::string& line)
{
    const auto parts = split(line, " \t");
    ScenarioEntry entry{};
    const bool good = parts.size() == 9 && parse(parts[0], entry.bucket) && parse(parts[2], entry.width) &&
                      parse(parts[3], entry.height) && parse(parts[4], entry.start[0]) &&
                      parse(parts[5], entry.start[1]) && parse(parts[6], entry.goal[0]) &&
                      parse(parts[7], entry.goal[1]) && parse(parts[8], entry.optimalLength);
    if (!good)
        in.fail("expected 'bucket map width height start-x start-y goal-x goal-y length', found ", inQuotes(line));
    entry.map = parts[1];
    return entry;
}
}  // namespace

GridMap readMovingAiMap(const std::string& path)
{
    return parseMovingAiMap(readText(path), path);
}

GridMap parseMovingAiMap(std::string text, const std::string& name)
{
    LineReader in(std::move(text), name);
    if (const std::string line = in.expect("'type octile'"); split(line, " \t") != split("type octile", " "))
        in.fail("expected 'type octile', found ", inQuotes(line));
    const int height = readSize(in, "height");
    const int width = readSize(in, "width");
    if (static_cast<double>(height) * width > GridMap::kMaxCells)
        in.fail("expected at most 2^28 cells, found ", width, " x ", height);
    if (const std::string line = in.expect("'map'"); line != "map")
        in.fail("expected 'map', found ", inQuotes(line));
    GridMap map(width, height);
    for (int y = 0; y < height; ++y)
        readRow(in, map, y);
    for (std::string rest; in.next(rest);)
        if (!split(rest, " \t").empty())
            in.fail("expected the end of the file after ", height, " rows");
    return map;
}

void writeMovingAiMap(const std::string& path, const GridMap& map)
{
    writeFile(path,
              [&map](std::ostream& out)
              {
                  out << "type octile\nheight " << map.height() << "\nwidth " << map.width() << "\nmap\n";
                  for (int y = 0; y < map.height(); ++y)
                  {
                      for (int x = 0; x < map.width(); ++x)
                          out << (map.isFree(x, y) ? '.' : '@');
                      out << '\n';
                  }
              });
}

std::vector<ScenarioEntry> readMovingAiScenario(const std::string& path)
{
    return parseMovingAiScenario(readText(path), path);
}

std::vector<ScenarioEntry> parseMovingAiScenario(std::string text, const std::string& name)
{
    LineReader in(std::move(text), name);
    const std::string first = in.expect("'version 1'");
    const auto version = split(first, " \t");
    if (version.size() != 2 || version[0] != "version" || (version[1] != "1" && version[1] != "1.0"))
        in.fail("expected 'version 1', found ", inQuotes(first));
    std::vector<ScenarioEntry> entries;
    for (std::string line; in.next(line);)
        if (!split(line, " \t").empty())
            entries.push_back(readEntry(in, line));
    return entries;
}

void writeMovingAiScenario(const std::string& path, const std::vector<ScenarioEntry>& entries)
{
    writeFile(path,
              [&entries](std::ostream& out)
              {
                  out << "version 1\n" << std::fixed << std::setprecision(8);
                  for (const ScenarioEntry& entry : entries)
                      out << entry.bucket << '\t' << entry.map << '\t' << entry.width << '\t' << entry.height << '\t'
                          << entry.start[0] << '\t' << entry.start[1] << '\t' << entry.goal[0] << '\t' << entry.goal[1]
                          << '\t' << entry.optimalLength << '\n';
              });
}
}  // namespace specplan::problems
