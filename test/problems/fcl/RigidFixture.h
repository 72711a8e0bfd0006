// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <string>

#include "TemporaryFolder.h"
#include "specplan/problems/fcl/MeshFile.h"

namespace specplan::test
{
inline problems::Mesh boxMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
    problems::Mesh mesh;
    problems::addBox(mesh, low, high);
    return mesh;
}

/// A room of 10 x 10 x 3 with a wall across at x = 5 that leaves a door from y = 0 to 2; walls 0.2 thick, no floor.
inline problems::Mesh roomMesh()
{
    problems::Mesh mesh;
    problems::addBox(mesh, {-0.2, -0.2, 0.0}, {0.0, 10.2, 3.0});
    problems::addBox(mesh, {10.0, -0.2, 0.0}, {10.2, 10.2, 3.0});
    problems::addBox(mesh, {0.0, -0.2, 0.0}, {10.0, 0.0, 3.0});
    problems::addBox(mesh, {0.0, 10.0, 0.0}, {10.0, 10.2, 3.0});
    problems::addBox(mesh, {4.9, 2.0, 0.0}, {5.1, 10.0, 3.0});
    return mesh;
}

/// A folder with that room, a robot of 1 x 0.4 x 1 off its origin, and the problem to go around the wall.
class RoomFolder
{
public:
    RoomFolder()
    {
        problems::writeObj(folder / "room.obj", roomMesh());
        problems::writeObj(folder / "robot.obj", boxMesh({100.0, 50.0, 1.0}, {101.0, 50.4, 2.0}));
    }

    static std::string planar()
    {
        return "[problem]\nname = room\nrobot = robot.obj\nworld = room.obj\n"
               "start.x = 2\nstart.y = 8\nstart.theta = 0\ngoal.x = 8\ngoal.y = 8\ngoal.theta = 1.5\n"
               "[benchmark]\ntime_limit = 2\nrun_count = 2\n[planner]\nrrtconnect =\n";
    }

    static std::string spatial()
    {
        return "[problem]\nname = room\nrobot = robot.obj\nworld = room.obj\n"
               "start.x = 2\nstart.y = 8\nstart.z = 1.5\nstart.theta = 0\nstart.axis.x = 0\nstart.axis.y = 0\n"
               "start.axis.z = 1\ngoal.x = 8\ngoal.y = 8\ngoal.z = 1.5\ngoal.theta = 1.5\ngoal.axis.x = 0\n"
               "goal.axis.y = 0\ngoal.axis.z = 1\n[benchmark]\ntime_limit = 2\nrun_count = 2\n[planner]\nrrtconnect "
               "=\n";
    }

    TemporaryFolder folder;
};

/// A pose within the box, any rotation.
inline Eigen::Isometry3d randomPose(std::mt19937& dice, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 3; ++i)
        pose.translation()[i] = low[i] + unit(dice) * (high[i] - low[i]);
    pose.linear() =
        Eigen::Quaterniond(normal(dice), normal(dice), normal(dice), normal(dice)).normalized().toRotationMatrix();
    return pose;
}
}  // namespace specplan::test
