// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/RigidBodyChecker.h"

#include <stdexcept>
#include <utility>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

namespace specplan::problems
{
namespace ob = ompl::base;

namespace
{
/// Room for the poses of a state; most have one body, which needs no memory from the heap.
class Poses
{
public:
    explicit Poses(std::size_t count) : many_(count > 1 ? count : 0), count_(count)
    {
    }

    [[nodiscard]] Eigen::Isometry3d* data()
    {
        return count_ > 1 ? many_.data() : &one_;
    }

    [[nodiscard]] std::span<const Eigen::Isometry3d> view()
    {
        return {data(), count_};
    }

private:
    Eigen::Isometry3d one_;
    std::vector<Eigen::Isometry3d> many_;
    std::size_t count_;
};

bool isPoseSpace(const ob::StateSpace& space)
{
    return space.getType() == ob::STATE_SPACE_SE2 || space.getType() == ob::STATE_SPACE_SE3;
}

/// How many bodies a space places. \throws std::invalid_argument if it is no space of poses.
std::size_t countBodies(const ob::StateSpace& space)
{
    if (isPoseSpace(space))
        return 1;
    const auto* compound = dynamic_cast<const ob::CompoundStateSpace*>(&space);
    bool good = compound != nullptr && compound->getSubspaceCount() > 0;
    for (unsigned i = 0; good && i < compound->getSubspaceCount(); ++i)
        good = isPoseSpace(*compound->getSubspace(i));
    if (!good)
        throw std::invalid_argument("the state space '" + space.getName() +
                                    "' must be SE2, SE3 or a compound of these");
    return compound->getSubspaceCount();
}

void writePose(const ob::StateSpace& space, const ob::State* state, Eigen::Isometry3d& pose)
{
    pose = Eigen::Isometry3d::Identity();
    if (space.getType() == ob::STATE_SPACE_SE2)
    {
        const auto* planar = state->as<ob::SE2StateSpace::StateType>();
        pose.translation() = Eigen::Vector3d(planar->getX(), planar->getY(), 0.0);
        pose.linear() = Eigen::AngleAxisd(planar->getYaw(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
        return;
    }
    const auto* spatial = state->as<ob::SE3StateSpace::StateType>();
    const auto& rotation = spatial->rotation();
    pose.translation() = Eigen::Vector3d(spatial->getX(), spatial->getY(), spatial->getZ());
    pose.linear() = Eigen::Quaterniond(rotation.w, rotation.x, rotation.y, rotation.z).toRotationMatrix();
}

void writePoses(const ob::StateSpace& space, const ob::State* state, Eigen::Isometry3d* poses)
{
    if (isPoseSpace(space))
    {
        writePose(space, state, *poses);
        return;
    }
    const auto& compound = static_cast<const ob::CompoundStateSpace&>(space);
    const auto* states = state->as<ob::CompoundState>();
    for (unsigned i = 0; i < compound.getSubspaceCount(); ++i)
        writePose(*compound.getSubspace(i), states->components[i], poses[i]);
}
}  // namespace

std::vector<Eigen::Isometry3d> posesOf(const ob::StateSpace& space, const ob::State* state)
{
    std::vector<Eigen::Isometry3d> poses(countBodies(space));
    writePoses(space, state, poses.data());
    return poses;
}

RigidBodyChecker::RigidBodyChecker(const ob::SpaceInformationPtr& si, std::shared_ptr<const RigidBodyScene> scene)
    : ob::StateValidityChecker(si), scene_(std::move(scene))
{
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
    const std::size_t bodies = countBodies(*si->getStateSpace());
    if (bodies != scene_->robots().size())
        throw std::invalid_argument("the state space '" + si->getStateSpace()->getName() + "' holds " +
                                    std::to_string(bodies) + " poses, but the scene has " +
                                    std::to_string(scene_->robots().size()) + " robots");
}

bool RigidBodyChecker::isValid(const ob::State* state) const
{
    if (!si_->satisfiesBounds(state))
        return false;
    Poses poses(scene_->robots().size());
    writePoses(*si_->getStateSpace(), state, poses.data());
    return !scene_->collides(poses.view());
}

double RigidBodyChecker::clearance(const ob::State* state) const
{
    Poses poses(scene_->robots().size());
    writePoses(*si_->getStateSpace(), state, poses.data());
    return scene_->distance(poses.view());
}
}  // namespace specplan::problems
