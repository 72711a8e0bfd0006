// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "specplan/problems/fcl/Mesh.h"

namespace specplan::make_meshes
{
/// A rigid-body problem: files "NAME.cfg", "NAME-robot.obj" and "NAME-world.obj". Lengths in metres.
struct RigidScene
{
    std::string name;
    std::string config;
    problems::Mesh robot;
    problems::Mesh world;
};

/// In the plane: a ladder on a trolley, 2.4 long, from one office to another across a corridor.
[[nodiscard]] RigidScene makeOffice();

/// In space: a grand piano from one half of a room through an opening and past a table into the other half.
[[nodiscard]] RigidScene makePiano();

/// In space: a bar, 1 long and 0.2 thick, through a hole of 0.3 x 0.3. The bar starts across the hole; to turn it where
/// it is and then to push it through is the shortest way, and as long as the distance of start and goal.
[[nodiscard]] RigidScene makePassage();

/// All scenes that come with the project.
[[nodiscard]] std::vector<RigidScene> makeAllRigidScenes();

/// Writes the three files of a scene. \throws InputError if that cannot be done.
void writeRigidScene(const std::string& folder, const RigidScene& scene);
}  // namespace specplan::make_meshes
