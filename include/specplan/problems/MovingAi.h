// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "specplan/problems/GridMap.h"

namespace specplan::problems
{
/// One line of a Moving AI scenario file.
struct ScenarioEntry
{
    int bucket;
    std::string map;  ///< as the file names it
    int width;
    int height;
    GridCell start;
    GridCell goal;
    double optimalLength;  ///< octile, without corner cutting
};

/// Reads a map of the Moving AI Lab's benchmarks ("type octile"): '.', 'G' and 'S' are free; '@', 'O', 'T' and 'W' are
/// blocked. Source: N. Sturtevant, "Benchmarks for Grid-Based Pathfinding", 2012. \throws InputError naming file and
/// line.
[[nodiscard]] GridMap readMovingAiMap(const std::string& path);

/// The same of a text in memory. \param name what messages call it.
[[nodiscard]] GridMap parseMovingAiMap(std::string text, const std::string& name);

/// Writes such a map. \throws InputError if the file cannot be written.
void writeMovingAiMap(const std::string& path, const GridMap& map);

/// Reads a scenario file, "version 1" or "1.0", fields separated by tabs or blanks.
/// \throws InputError naming file and line.
[[nodiscard]] std::vector<ScenarioEntry> readMovingAiScenario(const std::string& path);

/// The same of a text in memory. \param name what messages call it.
[[nodiscard]] std::vector<ScenarioEntry> parseMovingAiScenario(std::string text, const std::string& name);

/// Writes a scenario file. \throws InputError if the file cannot be written.
void writeMovingAiScenario(const std::string& path, const std::vector<ScenarioEntry>& entries);
}  // namespace specplan::problems
