// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include <ompl/base/StateSpace.h>
#include <ompl/base/StateValidityChecker.h>

#include "specplan/planner/BuiltWithOmpl.h"
#include "specplan/problems/fcl/RigidBodyScene.h"

namespace specplan::problems
{
/// Poses of the rigid bodies of a state: one for SE2 and SE3, one for each part of a compound of these.
/// \throws std::invalid_argument if the space is none of these.
[[nodiscard]] std::vector<Eigen::Isometry3d> posesOf(const ompl::base::StateSpace& space,
                                                     const ompl::base::State* state);

/// Tells whether rigid bodies keep clear of the world and of each other.
///
/// The state space is SE2 or SE3, or for several bodies a compound of these. Motion in SE2 is in the plane z = 0, with
/// bodies and world in space.
///
/// Threads: any number of threads may call isValid() and clearance() of one checker at once; it has no state of its
/// own. A checker for each worker is as good and costs two pointers.
class RigidBodyChecker : public ompl::base::StateValidityChecker
{
public:
    /// \throws std::invalid_argument if the space does not hold one pose for each robot of the scene.
    RigidBodyChecker(const ompl::base::SpaceInformationPtr& si, std::shared_ptr<const RigidBodyScene> scene);

    /// Within the bounds and clear of everything.
    bool isValid(const ompl::base::State* state) const override;

    /// Distance in space to the nearest thing; 0 in collision, infinite in an empty world.
    double clearance(const ompl::base::State* state) const override;

    [[nodiscard]] const RigidBodyScene& scene() const noexcept
    {
        return *scene_;
    }

private:
    std::shared_ptr<const RigidBodyScene> scene_;
};
}  // namespace specplan::problems
