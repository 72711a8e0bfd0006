// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "Run.h"

namespace specplan::command
{
/// Draws a search as SVG: the map, expanded states from first (light) to last (dark), states checked ahead and never
/// used, states found invalid, and the path.
void drawSearch(std::ostream& out, const problems::GridProblem& problem, const Run& run);
}  // namespace specplan::command
