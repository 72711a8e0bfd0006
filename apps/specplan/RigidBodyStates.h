// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "Run.h"
#include "specplan/problems/fcl/RigidBodySetup.h"

namespace specplan::command
{
/// States of a search as places and poses in space, for pictures. Setup and run have to outlive it.
class RigidBodyStates
{
public:
    RigidBodyStates(const problems::RigidBodySetup& setup, const Run& run);

    /// Where the reference point may be; in the plane as high as the world.
    [[nodiscard]] Eigen::AlignedBox3d space() const;

    /// Place of a state given as numbers: x, y, yaw, or x, y, z and a quaternion. In the plane the height is 0.
    [[nodiscard]] Eigen::Vector3d placeOf(const std::vector<double>& state) const;

    [[nodiscard]] Eigen::Isometry3d poseOf(const ompl::base::State* state) const;
    [[nodiscard]] Eigen::Isometry3d start() const;
    [[nodiscard]] Eigen::Isometry3d goal() const;

    /// Places of the states checked ahead and never used; none of a planner other than ours.
    [[nodiscard]] std::vector<Eigen::Vector3d> checkedAndUnused() const;

private:
    const problems::RigidBodySetup& setup_;
    const Run& run_;
};
}  // namespace specplan::command
