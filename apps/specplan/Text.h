// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "specplan/problems/GridMap.h"

namespace specplan::command
{
/// Reads a duration with its unit: "5ms", "20us", "0.5s", "100ns".
/// \throws InputError that names the option.
[[nodiscard]] std::chrono::nanoseconds parseDuration(const std::string& option, const std::string& text);

/// Reads a cell, "x,y". \throws InputError that names the option.
[[nodiscard]] problems::GridCell parseCell(const std::string& option, const std::string& text);

/// Reads numbers of workers from 1 to 4096: a list "1,2,4", or a range "1..256" that doubles from one to the next and
/// ends with its last number; or both, "1..8,12". In rising order, each one once. \throws InputError that names the
/// option.
[[nodiscard]] std::vector<unsigned> parseWorkers(const std::string& option, const std::string& text);

/// "12.3 ms" and the like.
[[nodiscard]] std::string durationText(double seconds);

/// A number with so many places behind the point.
[[nodiscard]] std::string fixed(double value, int places);

/// JSON with two blanks a level and an end of line; bytes that are not UTF-8 are replaced, since JSON cannot hold them.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

/// The same on one line.
[[nodiscard]] std::string compactJsonText(const nlohmann::ordered_json& json);

/// Text as XML wants it.
[[nodiscard]] std::string escaped(const std::string& text);
}  // namespace specplan::command
