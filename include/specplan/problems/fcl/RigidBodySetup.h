// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/spaces/RealVectorBounds.h>
#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/BuiltWithOmpl.h"
#include "specplan/problems/ArtificialCheck.h"
#include "specplan/problems/OmplAppProblem.h"
#include "specplan/problems/fcl/Mesh.h"
#include "specplan/problems/fcl/RigidBodyScene.h"

namespace specplan::problems
{
/// A rigid-body problem with its meshes or its map of voxels, ready to be set up for OMPL any number of times.
///
/// As in OMPL.app the robot's mesh is moved so that the mean of its vertices is the origin (in the plane only along x
/// and y), bounds that the file does not give are those of the world, and bounds are enlarged to hold start and goal.
/// A world whose file's name ends in ".bt" or ".ot" is a map of OctoMap; its bounds are those of all known voxels.
class RigidBodySetup
{
public:
    /// What reads a mesh file as readMesh() does.
    using MeshReader = std::function<Mesh(const std::string& path)>;

    /// Reads the meshes. A robot that is larger than the world is a warning.
    /// \throws InputError, one line: a mesh cannot be used, or start or goal collides.
    explicit RigidBodySetup(OmplAppProblem problem);

    /// The same with another reader of meshes, such as one that reads them in a process of their own.
    RigidBodySetup(OmplAppProblem problem, const MeshReader& readMesh);

    /// A fresh SimpleSetup with space, bounds, checker, start, goal and objective, but no planner.
    /// \param check what each check takes besides its own work.
    [[nodiscard]] std::shared_ptr<ompl::geometric::SimpleSetup> makeSetup(ArtificialCheck check = {}) const;

    [[nodiscard]] const OmplAppProblem& problem() const noexcept
    {
        return problem_;
    }

    /// The robot about its reference point.
    [[nodiscard]] const Mesh& robot() const noexcept
    {
        return robot_;
    }

    /// The world; of a map of voxels, the surface of those that are occupied.
    [[nodiscard]] const Mesh& world() const noexcept
    {
        return world_;
    }

    [[nodiscard]] const std::shared_ptr<const RigidBodyScene>& scene() const noexcept
    {
        return scene_;
    }

    /// Bounds of the reference point: two axes in the plane, three in space.
    [[nodiscard]] const ompl::base::RealVectorBounds& bounds() const noexcept
    {
        return bounds_;
    }

    /// What the file says and nobody heeds, and what is odd about the problem; one line each.
    [[nodiscard]] const std::vector<std::string>& warnings() const noexcept
    {
        return problem_.warnings;
    }

private:
    [[nodiscard]] RigidBody readWorld(const MeshReader& readMesh);
    void findBounds();
    void warnOfSize();
    void requireFree(const RigidPose& pose, const char* what) const;
    [[nodiscard]] ompl::base::StateSpacePtr makeSpace() const;

    OmplAppProblem problem_;
    Mesh robot_;
    Mesh world_;
    Eigen::AlignedBox3d worldBounds_;
    std::shared_ptr<const RigidBodyScene> scene_;
    ompl::base::RealVectorBounds bounds_;
};
}  // namespace specplan::problems
