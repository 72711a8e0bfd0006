// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "specplan/problems/fcl/RigidBody.h"

namespace specplan::problems
{
/// Robots that move and a world that does not.
///
/// Threads: immutable; any number of threads may ask at once. FCL's requests and results are local to each call.
class RigidBodyScene
{
public:
    RigidBodyScene(std::vector<RigidBody> robots, RigidBody world);

    [[nodiscard]] const std::vector<RigidBody>& robots() const noexcept
    {
        return robots_;
    }

    [[nodiscard]] const RigidBody& world() const noexcept
    {
        return world_;
    }

    /// Whether a robot touches the world or another robot. \param poses one for each robot.
    [[nodiscard]] bool collides(std::span<const Eigen::Isometry3d> poses) const;

    /// The smallest distance of a robot to the world or another robot: 0 if they touch, infinite where there is nothing
    /// else. \param poses one for each robot.
    [[nodiscard]] double distance(std::span<const Eigen::Isometry3d> poses) const;

private:
    std::vector<RigidBody> robots_;
    RigidBody world_;
};
}  // namespace specplan::problems
