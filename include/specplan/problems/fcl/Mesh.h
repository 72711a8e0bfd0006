// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace specplan::problems
{
/// Triangles in space.
struct Mesh
{
    std::vector<Eigen::Vector3d> vertices;                ///< also those of no triangle
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
};

/// Refuses a mesh without triangles, with a corner that is no vertex, or with a coordinate that is no finite number.
/// \throws InputError naming the file.
void requireSound(const Mesh& mesh, const std::string& file);

/// Mean of all vertices: the reference point that OMPL.app gives a robot.
[[nodiscard]] Eigen::Vector3d centreOf(const Mesh& mesh);

/// Smallest box along the axes around all triangles.
[[nodiscard]] Eigen::AlignedBox3d boundsOf(const Mesh& mesh);

/// The mesh moved by a vector.
[[nodiscard]] Mesh moved(Mesh mesh, const Eigen::Vector3d& by);

/// The parts of a mesh that share no corner, in the order of their first triangles. Corners at the same place are one.
[[nodiscard]] std::vector<Mesh> connectedParts(const Mesh& mesh);

/// Adds a box along the axes, as twelve triangles that face outward.
void addBox(Mesh& mesh, const Eigen::Vector3d& low, const Eigen::Vector3d& high);
}  // namespace specplan::problems
