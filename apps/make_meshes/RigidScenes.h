// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "specplan/problems/fcl/Mesh.h"
#include "specplan/problems/fcl/OctoMap.h"

namespace specplan::make_meshes
{
/// A rigid-body problem: files "NAME.cfg", "NAME-robot.obj" and "NAME-world.obj", or "NAME-world.bt" if the world is a
/// map of voxels. Lengths in metres.
struct RigidScene
{
    std::string name;
    std::string config;
    problems::Mesh robot;
    problems::Mesh world;
    std::shared_ptr<const octomap::OcTree> map = nullptr;  ///< instead of the mesh
};

/// In the plane: a ladder on a trolley, 2.4 long, from one office to another across a corridor.
[[nodiscard]] RigidScene makeOffice();

/// In space: a grand piano from one half of a room through an opening and past a table into the other half.
[[nodiscard]] RigidScene makePiano();

/// In space: a bar, 1 long and 0.2 thick, through a hole of 0.3 x 0.3. The bar starts across the hole; to turn it where
/// it is and then to push it through is the shortest way, and as long as the distance of start and goal.
[[nodiscard]] RigidScene makePassage();

/// In the plane, among voxels of 0.1: a trolley with a pole from one room through a doorway and past a table, under
/// which it fits but for its pole. None where specplan was built without OctoMap.
[[nodiscard]] std::vector<RigidScene> makeVoxelScenes();

/// How OMPL.app writes down a problem. \param world name of the file. \param start, goal lines of the file.
[[nodiscard]] std::string configText(const std::string& name, const std::string& world, const std::string& what,
                                     const std::string& start, const std::string& goal,
                                     const std::vector<std::array<double, 2>>& volume);

/// Lines of such a file. \param which start or goal.
[[nodiscard]] std::string planarPoseText(const std::string& which, double x, double y, double theta);

/// All scenes that come with the project, as far as they can be made.
[[nodiscard]] std::vector<RigidScene> makeAllRigidScenes();

/// Writes the three files of a scene. \throws InputError if that cannot be done.
void writeRigidScene(const std::string& folder, const RigidScene& scene);
}  // namespace specplan::make_meshes
