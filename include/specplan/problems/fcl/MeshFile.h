// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "specplan/problems/fcl/Mesh.h"

namespace specplan::problems
{
/// Reads all meshes of a file, each where the file's scene puts it; COLLADA, STL, OBJ and what else Assimp knows. With
/// the same post-processing as in OMPL.app, so that the mean of the vertices is the same too. Assimp turns a COLLADA
/// file whose z axis is up so that y is up; OMPL.app's meshes are made for that.
///
/// \throws InputError naming the file: it cannot be read, holds no triangles, or a coordinate is no finite number.
[[nodiscard]] Mesh readMesh(const std::string& path);

/// Writes a mesh in Wavefront's OBJ format, nine digits a number. \throws InputError if the file cannot be written.
void writeObj(const std::string& path, const Mesh& mesh);
}  // namespace specplan::problems
