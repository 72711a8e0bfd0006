// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <string>

#include "Colours.h"
#include "GridMapProblem.h"
#include "Text.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
using problems::concat;
using problems::GridCell;
using problems::GridMap;

namespace
{
constexpr int kWidth = 900;  // pixels
constexpr int kMargin = 12;  // pixels
constexpr int kLegend = 30;  // pixels
constexpr const char* kOpen = "#c7e9c0";
constexpr const char* kInvalid = "#9a6a62";

/// One path element with all the given cells; cells side by side in a row become one rectangle.
void drawCells(std::ostream& out, std::vector<GridCell> cells, const char* colour)
{
    if (cells.empty())
        return;
    std::ranges::sort(
        cells, [](const GridCell& a, const GridCell& b) { return std::pair(a[1], a[0]) < std::pair(b[1], b[0]); });
    out << "<path fill=\"" << colour << "\" d=\"";
    for (std::size_t i = 0; i < cells.size();)
    {
        std::size_t end = i + 1;
        while (end < cells.size() && cells[end][1] == cells[i][1] && cells[end][0] == cells[end - 1][0] + 1)
            ++end;
        out << 'M' << cells[i][0] << ' ' << cells[i][1] << 'h' << end - i << "v1h-" << end - i << 'z';
        i = end;
    }
    out << "\"/>\n";
}

std::vector<GridCell> wallsOf(const GridMap& map)
{
    std::vector<GridCell> walls;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x)
            if (!map.isFree(x, y))
                walls.push_back({x, y});
    return walls;
}

void drawStates(std::ostream& out, const Run& run)
{
    using Fate = SpeculativeAStar::StateFate;
    std::array<std::vector<GridCell>, 4> byFate;
    if (run.planner)
        run.planner->visitStates([&byFate](const ompl::base::State* state, Fate fate)
                                 { byFate[static_cast<std::size_t>(fate)].push_back(problems::cellOf(state)); });
    drawCells(out, byFate[static_cast<std::size_t>(Fate::Open)], kOpen);
    drawCells(out, byFate[static_cast<std::size_t>(Fate::Invalid)], kInvalid);
    const std::vector<GridCell> expanded = cellsOf(run.expanded);
    const std::size_t shades = kExpandedColours.size();
    for (std::size_t shade = 0; shade < shades; ++shade)
    {
        const auto at = [&expanded](std::size_t part) { return expanded.begin() + static_cast<std::ptrdiff_t>(part); };
        const std::size_t n = expanded.size();
        drawCells(out, {at(n * shade / shades), at(n * (shade + 1) / shades)}, kExpandedColours[shade]);
    }
    drawCells(out, byFate[static_cast<std::size_t>(Fate::CheckedUnused)], kUnusedColour);
}

void drawPath(std::ostream& out, const problems::GridProblem& problem, const Run& run, double pixel)
{
    if (!run.path.empty())
    {
        out << "<polyline fill=\"none\" stroke=\"" << kPathColour << "\" stroke-linejoin=\"round\" stroke-width=\""
            << std::max(3.0 * pixel, 0.35) << "\" points=\"";
        for (const GridCell& cell : cellsOf(run.path))
            out << cell[0] + 0.5 << ',' << cell[1] + 0.5 << ' ';
        out << "\"/>\n";
    }
    const double radius = std::max(6.0 * pixel, 0.6);
    const auto mark = [&](const GridCell& cell, const char* colour, const char* title)
    {
        out << "<circle cx=\"" << cell[0] + 0.5 << "\" cy=\"" << cell[1] + 0.5 << "\" r=\"" << radius << "\" fill=\""
            << colour << "\" stroke=\"white\" stroke-width=\"" << radius / 4.0 << "\"><title>" << title
            << "</title></circle>\n";
    };
    mark(problem.start, kStartColour, "start");
    mark(problem.goal, kPathColour, "goal");
}

void drawLegend(std::ostream& out, const Run& run, double top)
{
    const SearchReport& report = run.report;
    struct Item
    {
        const char* colour;
        std::string text;
    };
    const std::array<Item, 5> items{
        {{kExpandedColours[4], concat("expanded: ", report.expansions)},
         {kOpen, "reached, not expanded"},
         {kInvalid, "found invalid"},
         {kUnusedColour, concat("checked ahead, never used: ",
                                report.speculativeChecks - report.speculativeDropped - report.speculativeUsed)},
         {kPathColour, run.solved() ? concat("path: ", fixed(report.cost, 2)) : "no path"}}};
    double x = kMargin;
    for (const Item& item : items)
    {
        out << "<rect x=\"" << x << "\" y=\"" << top << "\" width=\"12\" height=\"12\" fill=\"" << item.colour
            << "\"/><text x=\"" << x + 17.0 << "\" y=\"" << top + 10.5 << "\">" << item.text << "</text>\n";
        x += 36.0 + 6.4 * static_cast<double>(item.text.size());
    }
}
}  // namespace

void drawSearch(std::ostream& out, const problems::GridProblem& problem, const Run& run)
{
    const GridMap& map = problem.map;
    const double scale = static_cast<double>(kWidth - 2 * kMargin) / map.width();  // pixels a cell
    const double height = scale * map.height();
    const double total = height + 2.0 * kMargin + kLegend + 20.0;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kWidth << "\" height=\"" << total
        << "\" viewBox=\"0 0 " << kWidth << ' ' << total
        << "\" font-family=\"sans-serif\" font-size=\"12\" stroke=\"none\">\n<title>" << escaped(run.problem)
        << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"" << kMargin
        << "\" y=\"18\" font-size=\"13\">"
        << escaped(concat(run.problem, ": ", run.report.threads == 1 ? "sequential" : run.settings.speculationPolicy,
                          ", ", run.report.threads, run.report.threads == 1 ? " thread, " : " threads, ",
                          durationText(run.seconds())))
        << "</text>\n<g transform=\"translate(" << kMargin << ',' << kMargin + 14 << ") scale(" << scale
        << ")\" shape-rendering=\"crispEdges\">\n<rect width=\"" << map.width() << "\" height=\"" << map.height()
        << "\" fill=\"#f7f7f5\"/>\n";
    drawCells(out, wallsOf(map), kWallColour);
    drawStates(out, run);
    out << "<g shape-rendering=\"auto\">\n";
    drawPath(out, problem, run, 1.0 / scale);
    out << "</g>\n</g>\n";
    drawLegend(out, run, height + 2.0 * kMargin + 14.0);
    out << "</svg>\n";
}
}  // namespace specplan::command
