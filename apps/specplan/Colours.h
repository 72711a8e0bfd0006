// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace specplan::command
{
/// Of expanded states, from first to last.
inline constexpr std::array<const char*, 8> kExpandedColours{"#deebf7", "#c6dbef", "#9ecae1", "#7fb9dc",
                                                             "#6baed6", "#4a98c9", "#3182bd", "#1f6aa8"};
inline constexpr const char* kWallColour = "#3b3f45";
inline constexpr const char* kUnusedColour = "#fdae61";  ///< checked ahead and never used
inline constexpr const char* kPathColour = "#d7191c";    ///< and the goal
inline constexpr const char* kStartColour = "#1a9641";
inline constexpr const char* kRobotColour = "#7b3294";  ///< along the path
}  // namespace specplan::command
