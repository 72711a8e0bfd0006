// SPDX-License-Identifier: BSD-3-Clause
#include "ProblemFile.h"

#include <filesystem>

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
        throw InputError(
            concat("--index: expected 0 to ", entries - 1, " or 'last' for ", file, ", found '", text, "'"));
    return static_cast<std::size_t>(index);
}

NamedProblem fromScenario(const std::string& file, const GridMap& map, const std::string& scenario,
                          const std::string& index)
{
    const auto entries = problems::readMovingAiScenario(scenario);
    const std::size_t chosen = entryIndex(index, scenario, entries.size());
    const ScenarioEntry& entry = entries[chosen];
    if (entry.width != map.width() || entry.height != map.height())
        throw InputError(scenario, 0,
                         concat("entry ", chosen, " is for a map of ", entry.width, " x ", entry.height, " cells, but ",
                                file, " has ", map.width(), " x ", map.height()));
    return {concat(file, " #", chosen), file, {map, entry.start, entry.goal}, false};
}

NamedProblem readMovingAi(const std::string& file, const ProblemOptions& options)
{
    const GridMap map = problems::readMovingAiMap(file);
    if (options.start && options.goal)
        return {file, file, {map, *options.start, *options.goal}, false};
    if (options.start || options.goal)
        throw InputError("expected --start and --goal together");
    if (!options.scenario.empty())
        return fromScenario(file, map, options.scenario, options.index);
    if (const std::string beside = file + ".scen"; std::filesystem::exists(beside))
        return fromScenario(file, map, beside, options.index);
    throw InputError(file, 0, "a map needs --start x,y and --goal x,y, or --scen FILE and --index I");
}
}  // namespace

NamedProblem readProblem(const std::string& file, const ProblemOptions& options)
{
    if (std::filesystem::path(file).extension() == ".cfg")
        throw InputError(
            file, 0, "OMPL.app problems cannot be read yet; expected a Moving AI map or a map in the seed's format");
    if (!problems::looksLikeSeedMap(file))
    {
        NamedProblem problem = readMovingAi(file, options);
        problem.cornerCutting = options.cornerCutting;
        return problem;
    }
    if (!options.scenario.empty())
        throw InputError(file, 0, "this map names its own start and goal and takes no --scen");
    NamedProblem problem{file, file, problems::readSeedMap(file), true};
    problem.problem.start = options.start.value_or(problem.problem.start);
    problem.problem.goal = options.goal.value_or(problem.problem.goal);
    return problem;
}
}  // namespace specplan::command
