// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "Run.h"
#include "specplan/problems/fcl/RigidBodySetup.h"

namespace specplan::command
{
/// Draws a search as SVG: the world, the robot along the path, expanded states from first (light) to last (dark) and
/// states checked ahead and never used. From above for a problem in the plane; from above, from the front and from the
/// side for one in space.
void drawSearch(std::ostream& out, const problems::RigidBodySetup& setup, const Run& run);
}  // namespace specplan::command
