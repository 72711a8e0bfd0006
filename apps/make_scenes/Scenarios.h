// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "specplan/problems/GridMap.h"
#include "specplan/problems/MovingAi.h"

namespace specplan::make_scenes
{
/// Octile distance from `from` to every cell, row by row, without corner cutting; infinite where there is no way. By
/// Dijkstra's algorithm, written apart from the planner so that each can test the other.
[[nodiscard]] std::vector<double> distancesFrom(const problems::GridMap& map, problems::GridCell from);

/// Ten queries of growing length; the last one is about the longest that the map has.
[[nodiscard]] std::vector<problems::ScenarioEntry> makeScenario(const problems::GridMap& map, const std::string& file);
}  // namespace specplan::make_scenes
