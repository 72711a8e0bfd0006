// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/RigidBodyScene.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "VoxelSurface.h"

namespace specplan::problems
{
namespace
{
using Part = RigidBody::Part;

/// Distance of the balls around two parts; below 0 where they overlap.
double gap(const Part& a, const Eigen::Isometry3d& poseA, const Part& b, const Eigen::Isometry3d& poseB)
{
    return (poseA * a.centre - poseB * b.centre).norm() - a.radius - b.radius;
}

bool collide(const RigidBody& a, const Eigen::Isometry3d& poseA, const RigidBody& b, const Eigen::Isometry3d& poseB)
{
    const fcl::CollisionRequestd request;  // yes or no: no contacts, and the first hit ends it
    for (const Part& partA : a.parts())
        for (const Part& partB : b.parts())
        {
            if (gap(partA, poseA, partB, poseB) > 0.0)
                continue;
            fcl::CollisionResultd result;
            if (fcl::collide(partA.geometry.get(), poseA * partA.pose, partB.geometry.get(), poseB * partB.pose,
                             request, result) > 0)
                return true;
        }
    return false;
}

/// What distances are measured to. FCL's distance of an octree and a mesh is right, but takes some hundred times as
/// long as that of the surface of its voxels.
const fcl::CollisionGeometryd* outsideOf(const Part& part)
{
    return part.surface ? &part.surface->geometry() : part.geometry.get();
}

/// The smaller of `least` and the distance of two bodies.
double nearer(double least, const RigidBody& a, const Eigen::Isometry3d& poseA, const RigidBody& b,
              const Eigen::Isometry3d& poseB)
{
    const fcl::DistanceRequestd request;
    for (const Part& partA : a.parts())
        for (const Part& partB : b.parts())
        {
            if (gap(partA, poseA, partB, poseB) >= least)
                continue;
            fcl::DistanceResultd result;
            fcl::distance(outsideOf(partA), poseA * partA.pose, outsideOf(partB), poseB * partB.pose, request, result);
            least = std::min(least, std::max(result.min_distance, 0.0));
        }
    return least;
}
}  // namespace

RigidBodyScene::RigidBodyScene(std::vector<RigidBody> robots, RigidBody world)
    : robots_(std::move(robots)), world_(std::move(world))
{
}

bool RigidBodyScene::collides(std::span<const Eigen::Isometry3d> poses) const
{
    assert(poses.size() == robots_.size());
    for (std::size_t i = 0; i < robots_.size(); ++i)
        if (collide(robots_[i], poses[i], world_, Eigen::Isometry3d::Identity()))
            return true;
    for (std::size_t i = 0; i < robots_.size(); ++i)
        for (std::size_t j = i + 1; j < robots_.size(); ++j)
            if (collide(robots_[i], poses[i], robots_[j], poses[j]))
                return true;
    return false;
}

double RigidBodyScene::distance(std::span<const Eigen::Isometry3d> poses) const
{
    assert(poses.size() == robots_.size());
    // Bodies that touch have distance 0, however deep; FCL's distance of overlapping bodies means different things for
    // different kinds of geometry.
    if (collides(poses))
        return 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < robots_.size(); ++i)
    {
        least = nearer(least, robots_[i], poses[i], world_, Eigen::Isometry3d::Identity());
        for (std::size_t j = i + 1; j < robots_.size(); ++j)
            least = nearer(least, robots_[i], poses[i], robots_[j], poses[j]);
    }
    return least;
}
}  // namespace specplan::problems
