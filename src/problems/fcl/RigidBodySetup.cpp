// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/RigidBodySetup.h"

#include <algorithm>
#include <utility>

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "specplan/problems/InputError.h"
#include "specplan/problems/fcl/MeshFile.h"
#include "specplan/problems/fcl/OctoMap.h"
#include "specplan/problems/fcl/RigidBodyChecker.h"

namespace specplan::problems
{
namespace ob = ompl::base;

namespace
{
constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

/// A checker whose checks take longer.
class SlowRigidBodyChecker : public RigidBodyChecker
{
public:
    SlowRigidBodyChecker(const ob::SpaceInformationPtr& si, std::shared_ptr<const RigidBodyScene> scene,
                         ArtificialCheck check)
        : RigidBodyChecker(si, std::move(scene)), check_(check)
    {
    }

    bool isValid(const ob::State* state) const override
    {
        pass(check_);
        return RigidBodyChecker::isValid(state);
    }

private:
    ArtificialCheck check_;
};

Eigen::Isometry3d isometryOf(const RigidPose& pose)
{
    Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
    isometry.translation() = Eigen::Vector3d(pose.position[0], pose.position[1], pose.position[2]);
    const Eigen::Vector3d axis(pose.axis[0], pose.axis[1], pose.axis[2]);
    isometry.linear() = Eigen::AngleAxisd(pose.angle, axis.normalized()).toRotationMatrix();
    return isometry;
}

void writeState(const RigidPose& pose, ob::State* state, bool planar)
{
    if (planar)
    {
        auto* se2 = state->as<ob::SE2StateSpace::StateType>();
        se2->setXY(pose.position[0], pose.position[1]);
        se2->setYaw(pose.angle);
        return;
    }
    auto* se3 = state->as<ob::SE3StateSpace::StateType>();
    se3->setXYZ(pose.position[0], pose.position[1], pose.position[2]);
    se3->rotation().setAxisAngle(pose.axis[0], pose.axis[1], pose.axis[2], pose.angle);
}

ob::OptimizationObjectivePtr makeObjective(const OmplAppProblem& problem, const ob::SpaceInformationPtr& si)
{
    ob::OptimizationObjectivePtr objective;
    switch (problem.objective)
    {
        case RigidObjective::Length:
            objective = std::make_shared<ob::PathLengthOptimizationObjective>(si);
            break;
        case RigidObjective::MaxMinClearance:
            objective = std::make_shared<ob::MaximizeMinClearanceObjective>(si);
            break;
        case RigidObjective::MechanicalWork:
            objective = std::make_shared<ob::MechanicalWorkOptimizationObjective>(si);
            break;
    }
    if (problem.objectiveThreshold)
        objective->setCostThreshold(ob::Cost(*problem.objectiveThreshold));
    return objective;
}

std::string sizeText(const Eigen::AlignedBox3d& box)
{
    const Eigen::Vector3d size = box.sizes();
    return concat(size.x(), " x ", size.y(), " x ", size.z());
}
}  // namespace

RigidBodySetup::RigidBodySetup(OmplAppProblem problem) : RigidBodySetup(std::move(problem), &problems::readMesh)
{
}

RigidBodySetup::RigidBodySetup(OmplAppProblem problem, const MeshReader& readMesh)
    : problem_(std::move(problem)), robot_(readMesh(problem_.robot.path)), bounds_(problem_.planar ? 2 : 3)
{
    Eigen::Vector3d centre = centreOf(robot_);
    if (problem_.planar)
        centre.z() = 0.0;
    robot_ = moved(std::move(robot_), -centre);
    scene_ = std::make_shared<const RigidBodyScene>(std::vector{RigidBody().addMesh(robot_)}, readWorld(readMesh));
    warnOfSize();
    findBounds();
    requireFree(problem_.start, "start");
    requireFree(problem_.goal, "goal");
}

RigidBody RigidBodySetup::readWorld(const MeshReader& readMesh)
{
    if (isOctoMapFile(problem_.world.path))
    {
        const auto map = readOctoMap(problem_.world.path);
        world_ = surfaceOf(*map);
        worldBounds_ = boundsOf(*map);
        return RigidBody().addOctoMap(*map);
    }
    world_ = readMesh(problem_.world.path);
    worldBounds_ = boundsOf(world_);
    return RigidBody().addMesh(world_);
}

void RigidBodySetup::warnOfSize()
{
    const Eigen::AlignedBox3d robot = boundsOf(robot_);
    if (robot.diagonal().norm() > worldBounds_.diagonal().norm())
        problem_.warnings.push_back(
            printable(concat(problem_.file, ':', problem_.robot.line, ": the robot, ", sizeText(robot),
                             ", is larger than the world, ", sizeText(worldBounds_), "; are both in the same unit?")));
}

void RigidBodySetup::findBounds()
{
    for (unsigned i = 0; i < bounds_.low.size(); ++i)
    {
        bounds_.low[i] = problem_.volume ? problem_.volume->low[i] : worldBounds_.min()[i];
        bounds_.high[i] = problem_.volume ? problem_.volume->high[i] : worldBounds_.max()[i];
        for (const RigidPose* pose : {&problem_.start, &problem_.goal})
        {
            const double place = pose->position[i];
            if (problem_.volume && (place < bounds_.low[i] || place > bounds_.high[i]))
                problem_.warnings.push_back(
                    printable(concat(problem_.file, ':', pose->line, ": ", kAxes[i], " = ", place,
                                     " is outside of the volume, which is enlarged to hold it")));
            bounds_.low[i] = std::min(bounds_.low[i], place);
            bounds_.high[i] = std::max(bounds_.high[i], place);
        }
        if (bounds_.low[i] >= bounds_.high[i])
            throw InputError(problem_.file, 0,
                             concat("expected problem.volume.min.", kAxes[i], " and problem.volume.max.", kAxes[i],
                                    ": the world is flat along ", kAxes[i]));
    }
}

void RigidBodySetup::requireFree(const RigidPose& pose, const char* what) const
{
    const std::array<Eigen::Isometry3d, 1> poses{isometryOf(pose)};
    if (scene_->collides(poses))
        throw InputError(problem_.file, pose.line,
                         concat("expected a free ", what, ", but there the robot collides with the world"));
}

ob::StateSpacePtr RigidBodySetup::makeSpace() const
{
    ob::StateSpacePtr space;
    if (problem_.planar)
    {
        auto se2 = std::make_shared<ob::SE2StateSpace>();
        se2->setBounds(bounds_);
        space = se2;
    }
    else
    {
        auto se3 = std::make_shared<ob::SE3StateSpace>();
        se3->setBounds(bounds_);
        space = se3;
    }
    if (problem_.longestValidSegmentFraction)
        space->setLongestValidSegmentFraction(*problem_.longestValidSegmentFraction);
    return space;
}

std::shared_ptr<ompl::geometric::SimpleSetup> RigidBodySetup::makeSetup(ArtificialCheck check) const
{
    const ob::StateSpacePtr space = makeSpace();
    auto setup = std::make_shared<ompl::geometric::SimpleSetup>(space);
    const ob::SpaceInformationPtr& si = setup->getSpaceInformation();
    if (check.duration.count() > 0)
        setup->setStateValidityChecker(std::make_shared<SlowRigidBodyChecker>(si, scene_, check));
    else
        setup->setStateValidityChecker(std::make_shared<RigidBodyChecker>(si, scene_));
    setup->setOptimizationObjective(makeObjective(problem_, si));
    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    writeState(problem_.start, start.get(), problem_.planar);
    writeState(problem_.goal, goal.get(), problem_.planar);
    start.enforceBounds();
    goal.enforceBounds();
    setup->setStartAndGoalStates(start, goal, problem_.goalThreshold);
    return setup;
}
}  // namespace specplan::problems
