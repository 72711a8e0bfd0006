// SPDX-License-Identifier: BSD-3-Clause
#include "GridMapProblem.h"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <utility>

#include "Picture.h"
#include "Run.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/MovingAi.h"
#include "specplan/problems/SeedMap.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
using problems::concat;
using problems::GridMap;
using problems::InputError;
using problems::ScenarioEntry;

namespace
{
std::size_t entryIndex(const std::string& text, const std::string& file, std::size_t entries)
{
    if (entries == 0)
        throw InputError(file, 0, "expected at least one entry, found none");
    if (text == "last")
        return entries - 1;
    int index = 0;
    if (!problems::parse(text, index) || index < 0 || static_cast<std::size_t>(index) >= entries)
        throw InputError(concat("--index: expected 0 to ", entries - 1, " or 'last' for ", file, ", found ",
                                problems::inQuotes(text)));
    return static_cast<std::size_t>(index);
}

/// What was read before it is a problem.
struct NamedGrid
{
    std::string name;
    problems::GridProblem problem;
    std::vector<Input> inputs;
};

/// People copy and rename maps, so another name is no error.
void warnOfAnotherMap(const Input& map, const Input& scenario, std::size_t chosen, const ScenarioEntry& entry)
{
    const auto named = std::filesystem::path(entry.map).filename();
    if (map.file == map.name && named != std::filesystem::path(map.file).filename())
        std::cerr << problems::printable(concat("specplan: warning: ", scenario.name, ": entry ", chosen,
                                                " is for the map ", entry.map, ", not for ", map.name))
                  << '\n';
}

NamedGrid fromScenario(Input file, const GridMap& map, const std::string& scenarioFile, const std::string& index)
{
    Input scenario = readInput(scenarioFile);
    const auto entries = problems::parseMovingAiScenario(std::move(scenario.text), scenario.name);
    const std::size_t chosen = entryIndex(index, scenario.name, entries.size());
    const ScenarioEntry& entry = entries[chosen];
    if (entry.width != map.width() || entry.height != map.height())
        throw InputError(scenario.name, 0,
                         concat("entry ", chosen, " is for a map of ", entry.width, " x ", entry.height, " cells, but ",
                                file.name, " has ", map.width(), " x ", map.height()));
    warnOfAnotherMap(file, scenario, chosen, entry);
    return {concat(file.name, " #", chosen), {map, entry.start, entry.goal}, {std::move(file), std::move(scenario)}};
}

NamedGrid readMovingAi(Input file, const ProblemOptions& options)
{
    const GridMap map = problems::parseMovingAiMap(std::move(file.text), file.name);
    if (options.start && options.goal)
        return {file.name, {map, *options.start, *options.goal}, {file}};
    if (options.start || options.goal)
        throw InputError("expected --start and --goal together");
    if (!options.scenario.empty())
        return fromScenario(std::move(file), map, options.scenario, options.index);
    if (const std::string beside = file.file + ".scen"; std::filesystem::exists(beside))
        return fromScenario(std::move(file), map, beside, options.index);
    throw InputError(file.name, 0, "a map needs --start x,y and --goal x,y, or --scen FILE and --index I");
}

nlohmann::ordered_json cellsToJson(const std::vector<problems::GridCell>& cells)
{
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const problems::GridCell& cell : cells)
        json.push_back({cell[0], cell[1]});
    return json;
}
}  // namespace

GridMapProblem::GridMapProblem(std::string name, std::vector<Input> inputs, problems::GridProblem problem,
                               problems::GridCost cost, bool cornerCutting)
    : Problem(std::move(name)),
      inputs_(std::move(inputs)),
      problem_(std::move(problem)),
      cost_(cost),
      cornerCutting_(cornerCutting)
{
}

std::shared_ptr<ompl::geometric::SimpleSetup> GridMapProblem::makeSetup(problems::ArtificialCheck check) const
{
    return problems::makeGridSetup(problem_, inputs_.front().name, cost_, check);
}

std::vector<std::string> GridMapProblem::inputs() const
{
    std::vector<std::string> files;
    for (const Input& input : inputs_)
        files.push_back(input.file);
    return files;
}

PlannerSettings GridMapProblem::settle(PlannerSettings chosen) const
{
    const PlannerSettings grid = problems::gridPlannerSettings(cornerCutting_);
    chosen.spacing = grid.spacing;
    chosen.anytime = grid.anytime;
    chosen.objectiveInChecks = grid.objectiveInChecks;
    chosen.connectivity = grid.connectivity;
    chosen.cornerCutting = grid.cornerCutting;
    return chosen;
}

void GridMapProblem::draw(std::ostream& out, const Run& run) const
{
    drawSearch(out, problem_, run);
}

void GridMapProblem::describe(nlohmann::ordered_json& trace, const Run& run) const
{
    trace["width"] = problem_.map.width();
    trace["height"] = problem_.map.height();
    trace["start"] = cellsToJson({problem_.start}).front();
    trace["goal"] = cellsToJson({problem_.goal}).front();
    nlohmann::ordered_json& rows = trace["map"] = nlohmann::ordered_json::array();
    for (int y = 0; y < problem_.map.height(); ++y)
    {
        std::string row;
        for (int x = 0; x < problem_.map.width(); ++x)
            row += problem_.map.isFree(x, y) ? '.' : '@';
        rows.push_back(row);
    }
    trace["expanded"] = cellsToJson(cellsOf(run.expanded));
    trace["path"] = cellsToJson(cellsOf(run.path));
}

std::unique_ptr<Problem> readGridMapProblem(Input input, const ProblemOptions& options)
{
    if (options.validityResolution)
        throw InputError(concat("--validity-resolution: expected a .cfg problem with this, found ", input.name));
    if (!problems::looksLikeSeedMap(input.text))
    {
        NamedGrid grid = readMovingAi(std::move(input), options);
        return std::make_unique<GridMapProblem>(std::move(grid.name), std::move(grid.inputs), std::move(grid.problem),
                                                options.cost, options.cornerCutting);
    }
    if (!options.scenario.empty())
        throw InputError(input.name, 0, "this map names its own start and goal and takes no --scen");
    problems::GridProblem problem = problems::parseSeedMap(std::move(input.text), input.name);
    problem.start = options.start.value_or(problem.start);
    problem.goal = options.goal.value_or(problem.goal);
    // The seed's program always cuts corners.
    return std::make_unique<GridMapProblem>(input.name, std::vector{input}, std::move(problem), options.cost, true);
}

std::vector<problems::GridCell> cellsOf(const std::vector<std::vector<double>>& states)
{
    std::vector<problems::GridCell> cells;
    cells.reserve(states.size());
    for (const std::vector<double>& state : states)
        cells.push_back({static_cast<int>(std::lround(state[0])), static_cast<int>(std::lround(state[1]))});
    return cells;
}
}  // namespace specplan::command
