// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "specplan/problems/GridMap.h"

namespace specplan::problems
{
/// Reads a problem in the text format of the program that came with "Speculative Path Planning":
///
///     N            size: A,B
///     C            collision threshold
///     R            robot, a,b, counted from 1
///     T            target, a,b, counted from 1; of several lines (a moving target) the first counts
///     M            A lines of B costs, separated by commas
///
/// A cell is free where its cost is below the threshold. The first number of each pair becomes x, so the map is A wide.
/// \throws InputError naming file and line.
[[nodiscard]] GridProblem readSeedMap(const std::string& path);

/// The same of a text in memory. \param name what messages call it.
[[nodiscard]] GridProblem parseSeedMap(std::string text, const std::string& name);

/// Whether a text begins like one in this format.
[[nodiscard]] bool looksLikeSeedMap(std::string_view text);
}  // namespace specplan::problems
