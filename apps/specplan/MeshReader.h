// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "specplan/problems/fcl/Mesh.h"

namespace specplan::command
{
/// problems::readMesh() in a process of its own with bounded memory and time: a damaged file may crash Assimp or keep
/// it busy for ever. Only for a program that has no second thread yet. \throws InputError as readMesh() does, and where
/// the reader came to no good end.
[[nodiscard]] problems::Mesh readMeshApart(const std::string& path);
}  // namespace specplan::command
