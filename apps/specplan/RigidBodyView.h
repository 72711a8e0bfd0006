// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "Run.h"
#include "specplan/problems/fcl/RigidBodySetup.h"

namespace specplan::command
{
/// \throws InputError if specplan was built without three.js.
void requireViewer();

/// Writes a page that holds all it needs, with a 3-D view of a search: the world, the robot that moves along the path,
/// start and goal, expanded states from first (light) to last (dark) and states checked ahead and never used. Where
/// there are so many that the page would be larger than 10 MB, states are thinned out evenly, and the page says so.
/// \throws InputError as requireViewer() does.
void viewSearch(std::ostream& out, const problems::RigidBodySetup& setup, const Run& run);
}  // namespace specplan::command
