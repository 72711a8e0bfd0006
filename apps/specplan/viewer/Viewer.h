// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace specplan::command
{
// Files that the build put into the program.
extern const std::string_view kViewPage;         ///< view.html; what its {{NAME}}s stand for has to be filled in
extern const std::string_view kThreeJs;          ///< three.js; empty if it was not there
extern const std::string_view kOrbitControlsJs;  ///< its orbit control; likewise
}  // namespace specplan::command
