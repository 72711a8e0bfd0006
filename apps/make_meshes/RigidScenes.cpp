// SPDX-License-Identifier: BSD-3-Clause
#include "RigidScenes.h"

#include <iomanip>
#include <numbers>
#include <ostream>
#include <utility>

#include "specplan/problems/InputError.h"
#include "specplan/problems/OutputFile.h"
#include "specplan/problems/fcl/MeshFile.h"

namespace specplan::make_meshes
{
using problems::addBox;
using problems::concat;
using problems::Mesh;

std::string configText(const std::string& name, const std::string& world, const std::string& what,
                       const std::string& start, const std::string& goal,
                       const std::vector<std::array<double, 2>>& volume)
{
    std::string text = concat("# ", what, "\n[problem]\nname = ", name, "\nrobot = ", name,
                              "-robot.obj\nworld = ", world, '\n', start, goal);
    for (std::size_t i = 0; i < volume.size(); ++i)
        text +=
            concat("volume.min.", "xyz"[i], " = ", volume[i][0], "\nvolume.max.", "xyz"[i], " = ", volume[i][1], '\n');
    return text +
           "\n[benchmark]\ntime_limit = 10\nmem_limit = 2000\nrun_count = 10\n\n"
           "[planner]\nSpeculativeAStar =\nRRTConnect =\nBITstar =\n";
}

std::string planarPoseText(const std::string& which, double x, double y, double theta)
{
    return concat(std::setprecision(12), which, ".x = ", x, '\n', which, ".y = ", y, '\n', which, ".theta = ", theta,
                  '\n');
}

namespace
{
constexpr double kWall = 0.1;  // half the thickness of a wall

/// Turned about the vertical.
std::string spatialPose(const std::string& which, double x, double y, double z, double theta)
{
    return concat(std::setprecision(12), which, ".x = ", x, '\n', which, ".y = ", y, '\n', which, ".z = ", z, '\n',
                  which, ".theta = ", theta, '\n', which, ".axis.x = 0\n", which, ".axis.y = 0\n", which,
                  ".axis.z = 1\n");
}

/// A wall along x with gaps. \param gaps from and to, in order.
void addWall(Mesh& mesh, double from, double to, double y, double height,
             const std::vector<std::array<double, 2>>& gaps)
{
    double begin = from;
    for (const auto& [open, close] : gaps)
    {
        addBox(mesh, {begin, y - kWall, 0.0}, {open, y + kWall, height});
        begin = close;
    }
    addBox(mesh, {begin, y - kWall, 0.0}, {to, y + kWall, height});
}

void addTable(Mesh& mesh, const Eigen::Vector2d& low, const Eigen::Vector2d& high, double height)
{
    constexpr double kLeg = 0.08;
    addBox(mesh, {low.x(), low.y(), height - 0.04}, {high.x(), high.y(), height});
    for (const double x : {low.x(), high.x() - kLeg})
        for (const double y : {low.y(), high.y() - kLeg})
            addBox(mesh, {x, y, 0.0}, {x + kLeg, y + kLeg, height - 0.04});
}
}  // namespace

RigidScene makeOffice()
{
    constexpr double kLength = 20.0;
    constexpr double kWidth = 13.0;
    constexpr double kHeight = 2.5;
    Mesh world;
    // Around it all, and a corridor from end to end, 2.2 wide, with a door to every office.
    addWall(world, -kWall, kLength + kWall, 0.0, kHeight, {});
    addWall(world, -kWall, kLength + kWall, kWidth, kHeight, {});
    addWall(world, 0.0, kLength, 5.4, kHeight, {{1.5, 3.0}, {7.6, 9.1}, {12.2, 13.7}, {17.0, 18.5}});
    addWall(world, 0.0, kLength, 7.6, kHeight, {{2.4, 3.9}, {10.4, 11.9}, {15.6, 17.1}});
    for (const double x : {0.0, kLength})
        addBox(world, {x - kWall, kWall, 0.0}, {x + kWall, kWidth - kWall, kHeight});
    for (const double x : {5.0, 10.5, 15.0})
        addBox(world, {x - kWall, kWall, 0.0}, {x + kWall, 5.4 - kWall, kHeight});
    for (const double x : {6.5, 13.5})
        addBox(world, {x - kWall, 7.6 + kWall, 0.0}, {x + kWall, kWidth - kWall, kHeight});
    // Desks, a copier in the corridor, a column.
    addTable(world, {0.5, 0.4}, {2.1, 1.2}, 0.75);
    addTable(world, {6.2, 0.4}, {7.8, 1.2}, 0.75);
    addTable(world, {11.4, 0.3}, {13.8, 1.2}, 0.75);
    addTable(world, {1.0, 11.6}, {4.0, 12.6}, 0.75);
    addTable(world, {8.6, 10.2}, {11.0, 11.2}, 0.75);
    addTable(world, {17.6, 9.0}, {18.4, 11.4}, 0.75);
    addBox(world, {13.8, 5.5, 0.0}, {14.6, 6.1, 1.1});
    addBox(world, {5.0, 9.6, 0.0}, {5.4, 10.0, kHeight});

    Mesh robot;
    addBox(robot, {-1.2, -0.25, 0.6}, {1.2, 0.25, 0.8});
    addBox(robot, {-0.4, -0.25, 0.1}, {0.4, 0.25, 0.6});
    return {"office",
            configText("office", "office-world.obj",
                       "A ladder on a trolley, from one office to another across a corridor (metres).",
                       planarPoseText("start", 2.4, 2.6, 0.0), planarPoseText("goal", 16.0, 11.6, 0.0),
                       {{0.2, 19.8}, {0.2, 12.8}}),
            robot, world};
}

RigidScene makePiano()
{
    constexpr double kLength = 9.0;
    constexpr double kWidth = 5.0;
    constexpr double kHeight = 3.0;
    Mesh world;
    addBox(world, {-0.2, -0.2, -0.2}, {kLength + 0.2, kWidth + 0.2, 0.0});
    addBox(world, {-0.2, -0.2, kHeight}, {kLength + 0.2, kWidth + 0.2, kHeight + 0.2});
    addBox(world, {-0.2, -0.2, 0.0}, {0.0, kWidth + 0.2, kHeight});
    addBox(world, {kLength, -0.2, 0.0}, {kLength + 0.2, kWidth + 0.2, kHeight});
    addBox(world, {0.0, -0.2, 0.0}, {kLength, 0.0, kHeight});
    addBox(world, {0.0, kWidth, 0.0}, {kLength, kWidth + 0.2, kHeight});
    // Across the middle, with an opening 1.4 wide and 2.2 high.
    addBox(world, {4.4, 0.0, 0.0}, {4.6, 2.4, kHeight});
    addBox(world, {4.4, 3.8, 0.0}, {4.6, kWidth, kHeight});
    addBox(world, {4.4, 2.4, 2.2}, {4.6, 3.8, kHeight});
    addTable(world, {5.8, 1.6}, {7.2, 3.6}, 0.75);
    addTable(world, {2.6, 0.3}, {3.8, 1.5}, 0.75);

    // Body, tail, keyboard and three legs.
    Mesh robot;
    addBox(robot, {-0.75, -0.2, 0.3}, {0.75, 0.5, 0.6});
    addBox(robot, {-0.75, 0.5, 0.3}, {0.15, 1.1, 0.6});
    addBox(robot, {-0.75, -0.5, 0.3}, {0.75, -0.2, 0.45});
    addBox(robot, {-0.65, -0.3, 0.0}, {-0.53, -0.18, 0.3});
    addBox(robot, {0.53, -0.3, 0.0}, {0.65, -0.18, 0.3});
    addBox(robot, {-0.36, 0.9, 0.0}, {-0.24, 1.02, 0.3});
    return {"piano",
            configText("piano", "piano-world.obj", "A grand piano through an opening and past a table (metres).",
                       spatialPose("start", 1.4, 3.4, 0.5, 0.0), spatialPose("goal", 8.0, 1.2, 0.5, 0.0),
                       {{0.1, 8.9}, {0.1, 4.9}, {0.1, 2.9}}),
            robot, world};
}

RigidScene makePassage()
{
    constexpr double kHole = 0.15;   // half the size of the hole
    constexpr double kReach = 2.0;   // of the plate, farther than any place of the bar
    constexpr double kPlate = 0.25;  // half the thickness of the plate
    Mesh world;
    addBox(world, {-kPlate, -kReach, -kReach}, {kPlate, -kHole, kReach});
    addBox(world, {-kPlate, kHole, -kReach}, {kPlate, kReach, kReach});
    addBox(world, {-kPlate, -kHole, -kReach}, {kPlate, kHole, -kHole});
    addBox(world, {-kPlate, -kHole, kHole}, {kPlate, kHole, kReach});
    Mesh robot;
    addBox(robot, {-0.5, -0.1, -0.1}, {0.5, 0.1, 0.1});
    return {
        "passage",
        configText("passage", "passage-world.obj",
                   "A bar through a hole: turn it, then push it through. The shortest way costs 3 + pi / 4 (metres).",
                   spatialPose("start", -1.5, 0.0, 0.0, std::numbers::pi / 2.0),
                   spatialPose("goal", 1.5, 0.0, 0.0, 0.0), {{-2.0, 2.0}, {-1.0, 1.0}, {-1.0, 1.0}}),
        robot, world};
}

std::vector<RigidScene> makeAllRigidScenes()
{
    std::vector<RigidScene> scenes{makeOffice(), makePiano(), makePassage()};
    for (RigidScene& scene : makeVoxelScenes())
        scenes.push_back(std::move(scene));
    return scenes;
}

void writeRigidScene(const std::string& folder, const RigidScene& scene)
{
    const std::string path = folder + '/' + scene.name;
    problems::writeObj(path + "-robot.obj", scene.robot);
    if (scene.map)
        problems::writeOctoMap(path + "-world.bt", *scene.map);
    else
        problems::writeObj(path + "-world.obj", scene.world);
    problems::writeFile(path + ".cfg", [&scene](std::ostream& out) { out << scene.config; });
}
}  // namespace specplan::make_meshes
