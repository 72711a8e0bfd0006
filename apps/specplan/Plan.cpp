// SPDX-License-Identifier: BSD-3-Clause
#include "Plan.h"

#include <ostream>

#include "Picture.h"
#include "Results.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
namespace
{
nlohmann::ordered_json cellsToJson(const std::vector<problems::GridCell>& cells)
{
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const problems::GridCell& cell : cells)
        json.push_back({cell[0], cell[1]});
    return json;
}

/// The whole search as one JSON object: the figures, the map, the expanded cells in order, and the path.
void writeTrace(std::ostream& out, const problems::GridProblem& problem, const Run& run)
{
    nlohmann::ordered_json trace = toJson(run);
    trace["width"] = problem.map.width();
    trace["height"] = problem.map.height();
    trace["start"] = cellsToJson({problem.start}).front();
    trace["goal"] = cellsToJson({problem.goal}).front();
    nlohmann::ordered_json& rows = trace["map"] = nlohmann::ordered_json::array();
    for (int y = 0; y < problem.map.height(); ++y)
    {
        std::string row;
        for (int x = 0; x < problem.map.width(); ++x)
            row += problem.map.isFree(x, y) ? '.' : '@';
        rows.push_back(row);
    }
    trace["expanded"] = cellsToJson(run.expanded);
    trace["path"] = cellsToJson(run.path);
    out << trace.dump() << '\n';
}
}  // namespace

int plan(const PlanOptions& options, std::ostream& out)
{
    const NamedProblem problem = readProblem(options.problem.files.front(), options.problem);
    for (const std::string& file : {options.svgFile, options.traceFile, options.pathFile})
        if (!file.empty())
            problems::requireWritable(file);

    const bool keepOrder = !options.svgFile.empty() || !options.traceFile.empty();
    const Run run = planOnce(problem, options, options.planner, keepOrder);
    if (!options.svgFile.empty())
        problems::writeFile(options.svgFile, [&](std::ostream& file) { drawSearch(file, problem.problem, run); });
    if (!options.traceFile.empty())
        problems::writeFile(options.traceFile, [&](std::ostream& file) { writeTrace(file, problem.problem, run); });
    if (!options.pathFile.empty() && run.solved())
        problems::writeFile(options.pathFile,
                            [&](std::ostream& file) { run.setup->getSolutionPath().printAsMatrix(file); });
    if (options.json)
        out << toJson(run).dump(2) << '\n';
    else
        printRun(out, run);
    return run.solved() ? 0 : 1;
}
}  // namespace specplan::command
