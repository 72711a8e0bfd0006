// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include <fcl/geometry/collision_geometry.h>

#include "specplan/problems/fcl/Mesh.h"

namespace octomap
{
class OcTree;
}  // namespace octomap

namespace specplan::problems
{
class VoxelSurface;

/// A rigid body for collision tests: meshes, simple shapes and maps of voxels that keep their places to each other.
/// Lengths are in the unit of the problem.
///
/// A mesh is its surface: a body that lies inside a closed mesh without touching it does not collide with it. Shapes
/// and voxels are solid.
///
/// Threads: once made, any number of threads may use it at once. Copies share the geometry.
class RigidBody
{
public:
    /// One geometry and where it sits in the body.
    struct Part
    {
        std::shared_ptr<const fcl::CollisionGeometryd> geometry;
        Eigen::Isometry3d pose;
        Eigen::Vector3d centre;                                 ///< of a ball around the part, in the body's frame
        double radius;                                          ///< of that ball
        std::shared_ptr<const VoxelSurface> surface = nullptr;  ///< of voxels: what distances are measured to
    };

    /// Adds a mesh as one tree of bounding volumes (OBBRSS). It must have triangles.
    /// \throws std::invalid_argument if it has none.
    RigidBody& addMesh(const Mesh& mesh);

    /// Adds a solid box around the origin of `pose`. \param size edge lengths, greater than 0.
    RigidBody& addBox(const Eigen::Vector3d& size, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

    /// Adds a solid ball. \param radius greater than 0.
    RigidBody& addSphere(double radius, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

    /// Adds a solid cylinder around the z axis of `pose`, half of it below. \param radius, length greater than 0.
    RigidBody& addCylinder(double radius, double length, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

    /// Adds a solid cylinder with round ends. \param length without the ends.
    RigidBody& addCapsule(double radius, double length, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

    /// Adds a solid cone around the z axis of `pose`, half of it below, its tip up.
    RigidBody& addCone(double radius, double length, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

    /// Adds the occupied voxels of a map of OctoMap, as solid cubes; what is free or unknown does not count. What is
    /// occupied is decided by the map's own threshold. The map is copied, so it may go on changing.
    ///
    /// The first distance to it makes a mesh of the voxels' surface, which may take seconds for a large map; collisions
    /// need none.
    ///
    /// \throws std::invalid_argument if no voxel is occupied; std::logic_error where specplan was built without
    /// OctoMap.
    RigidBody& addOctoMap(const octomap::OcTree& map, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

    [[nodiscard]] const std::vector<Part>& parts() const noexcept
    {
        return parts_;
    }

private:
    RigidBody& add(std::shared_ptr<fcl::CollisionGeometryd> geometry, const Eigen::Isometry3d& pose);

    std::vector<Part> parts_;
};
}  // namespace specplan::problems
