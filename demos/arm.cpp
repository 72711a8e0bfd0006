// SPDX-License-Identifier: BSD-3-Clause
// A seven-axis arm reaches from one compartment of a shelf into another. The checker moves FCL capsules and boxes with
// the arm; everything it shares between threads is constant.
#include <array>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <numbers>
#include <vector>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/utility.h>
#include <fcl/narrowphase/collision.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>
#include <Eigen/Geometry>

#include <specplan/planner/SpeculativeAStar.h>

#include "Drawing.h"
#include "Solid.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
using demo::Box;
using demo::Capsule;
using demo::collide;

constexpr unsigned kAxes = 7;
using Joints = std::array<double, kAxes>;  // radians

/// Where the arm's bodies are: coordinate frames, metres. The z axes run along the limbs.
struct Pose
{
    Eigen::Isometry3d upperArm, forearm, wrist, gripper;
};

/// Forward kinematics by the Denavit-Hartenberg table of a common arm with a reach of 0.8 m.
Pose poseOf(const double* joints)
{
    constexpr double quarter = std::numbers::pi / 2.0;
    constexpr Joints alpha{-quarter, quarter, quarter, -quarter, -quarter, quarter, 0.0};
    constexpr Joints d{0.36, 0.0, 0.42, 0.0, 0.4, 0.0, 0.126};
    std::array<Eigen::Isometry3d, kAxes + 1> frames{Eigen::Isometry3d::Identity()};
    for (unsigned i = 0; i < kAxes; ++i)
        frames[i + 1] = frames[i] * Eigen::AngleAxisd(joints[i], Eigen::Vector3d::UnitZ()) *
                        Eigen::Translation3d(0.0, 0.0, d[i]) * Eigen::AngleAxisd(alpha[i], Eigen::Vector3d::UnitX());
    return {frames[2], frames[4], frames[6], frames[7]};
}

/// The arm's bodies. FCL's capsules lie along z with their middle in the origin.
struct Arm
{
    Capsule base, upperArm, forearm, wrist;
    Box gripper;

    explicit Arm(const double* joints) : Arm(poseOf(joints))
    {
    }

    explicit Arm(const Pose& pose)
        : base(fcl::Capsuled(0.10, 0.36), along(Eigen::Isometry3d::Identity(), 0.18)),
          upperArm(fcl::Capsuled(0.08, 0.42), along(pose.upperArm, 0.21)),
          forearm(fcl::Capsuled(0.07, 0.40), along(pose.forearm, 0.20)),
          wrist(fcl::Capsuled(0.05, 0.10), along(pose.wrist, 0.05)),
          gripper(fcl::Boxd(0.20, 0.05, 0.14), along(pose.gripper, 0.07))
    {
    }

    static Eigen::Isometry3d along(const Eigen::Isometry3d& frame, double z)
    {
        return frame * Eigen::Translation3d(0.0, 0.0, z);
    }

    bool hitsItself() const
    {
        return collide(forearm, base) || collide(wrist, base) || collide(gripper, base) || collide(wrist, upperArm) ||
               collide(gripper, upperArm);
    }

    bool hits(const Box& obstacle) const
    {
        return collide(upperArm, obstacle) || collide(forearm, obstacle) || collide(wrist, obstacle) ||
               collide(gripper, obstacle);
    }
};

/// The floor, and a shelf of two by two compartments that is open towards the arm.
std::vector<Box> makeObstacles()
{
    std::vector<Box> boxes{demo::boxBetween({-0.5, -0.9, -0.07}, {1.3, 0.9, -0.03}),
                           demo::boxBetween({0.95, -0.52, 0.08}, {0.99, 0.52, 1.02})};
    for (const double z : {0.08, 0.53, 0.98})
        boxes.push_back(demo::boxBetween({0.55, -0.52, z}, {0.95, 0.52, z + 0.04}));
    for (const double y : {-0.52, -0.02, 0.48})
        boxes.push_back(demo::boxBetween({0.55, y, 0.08}, {0.95, y + 0.04, 1.02}));
    return boxes;
}

const std::vector<Box>& obstacles()
{
    static const std::vector<Box> boxes = makeObstacles();
    return boxes;
}

bool isValid(const ob::State* state)
{
    const Arm arm(state->as<ob::RealVectorStateSpace::StateType>()->values);
    if (arm.hitsItself())
        return false;
    for (const Box& obstacle : obstacles())
        if (arm.hits(obstacle))
            return false;
    return true;
}

constexpr Joints kLimits{2.96, 2.09, 2.96, 2.09, 2.96, 2.09, 3.05};
constexpr Joints kStart{0.272, 0.912, 0.332, -1.647, 0.511, -1.148, 1.053};   // in the lower left compartment
constexpr Joints kGoal{0.183, 0.682, -1.384, -1.117, -1.043, -0.978, 0.288};  // in the upper right one

og::SimpleSetup makeSetup()
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(kAxes);
    ob::RealVectorBounds bounds(kAxes);
    for (unsigned i = 0; i < kAxes; ++i)
    {
        bounds.setLow(i, -kLimits[i]);
        bounds.setHigh(i, kLimits[i]);
    }
    space->setBounds(bounds);

    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(isValid);
    // OMPL's default, a hundredth of the space's diameter, lets the hand move by 15 cm between two checks.
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.003);
    ob::ScopedState<> start(space), goal(space);
    for (unsigned i = 0; i < kAxes; ++i)
    {
        start[i] = kStart[i];
        goal[i] = kGoal[i];
    }
    setup.setStartAndGoalStates(start, goal);
    return setup;
}

/// Plans for at most 30 s and prints a row. \return whether a path was found that holds.
bool plan(og::SimpleSetup& setup, const ob::PlannerPtr& planner)
{
    setup.setPlanner(planner);
    const ob::PlannerStatus status = setup.solve(30.0);
    const bool solved = status == ob::PlannerStatus::EXACT_SOLUTION && setup.getSolutionPath().check();
    std::cout << std::left << std::setw(18) << planner->getName() << std::setw(22) << status.asString() << std::right
              << std::fixed << std::setprecision(3) << std::setw(9) << setup.getLastPlanComputationTime();
    if (solved)
    {
        og::PathGeometric shorter = setup.getSolutionPath();
        setup.getPathSimplifier()->simplifyMax(shorter);
        std::cout << std::setw(9) << setup.getSolutionPath().length() << std::setw(12) << shorter.length();
    }
    return solved;
}

/// The arm seen along an axis: lines as thick as its limbs, and the gripper's outline.
void drawArm(demo::Drawing& drawing, std::size_t panel, const Arm& arm, const std::string& colour, double opacity)
{
    const int across = panel == 0 ? 0 : 1;  // from the side: x and z; from the front: y and z
    const auto flat = [across](const Eigen::Vector3d& p) { return demo::Point{p[across], p[2]}; };
    for (const Capsule* limb : {&arm.base, &arm.upperArm, &arm.forearm, &arm.wrist})
    {
        const Eigen::Vector3d half(0.0, 0.0, limb->shape.lz / 2.0);
        std::ostringstream style;
        style << "stroke=\"" << colour << "\" opacity=\"" << opacity << "\" stroke-width=\"" << 2.0 * limb->shape.radius
              << '"';
        drawing.line(panel, {flat(limb->place * -half), flat(limb->place * half)}, style.str());
    }
    std::ostringstream style;
    style << "fill=\"" << colour << "\" opacity=\"" << opacity << '"';
    drawing.polygon(panel, demo::outline(arm.gripper, across, 2), style.str());
}

void draw(og::PathGeometric path, const std::filesystem::path& file)
{
    constexpr unsigned kShown = 16;
    path.interpolate(kShown);
    demo::Drawing drawing("A seven-axis arm reaches into a shelf",
                          {{"from the side", -0.5, 1.2, -0.1, 1.4}, {"from the front", -0.8, 0.8, -0.1, 1.4}});
    for (std::size_t panel = 0; panel < 2; ++panel)
    {
        const int across = panel == 0 ? 0 : 1;
        for (const Box& box : obstacles())
            drawing.polygon(panel, demo::outline(box, across, 2), "fill=\"#3b3f45\" opacity=\"0.35\"");
        for (std::size_t i = 0; i < path.getStateCount(); ++i)
        {
            const Arm arm(path.getState(static_cast<unsigned>(i))->as<ob::RealVectorStateSpace::StateType>()->values);
            const bool first = i == 0;
            const bool last = i + 1 == path.getStateCount();
            drawArm(drawing, panel, arm, first ? "#1a9641" : last ? "#d7191c" : "#3182bd", first || last ? 0.8 : 0.15);
        }
    }
    drawing.save(file);
}

bool run(const std::filesystem::path& folder)
{
    std::cout << "planner           status                  seconds   length  simplified    checks   bound\n";
    og::SimpleSetup setup = makeSetup();
    auto planner = std::make_shared<specplan::SpeculativeAStar>(setup.getSpaceInformation());
    const bool solved = plan(setup, planner);
    std::cout << std::setw(10) << planner->getReport().checksTotal << std::setw(8) << std::setprecision(2)
              << planner->getReport().bound << '\n';
    if (solved)
    {
        const std::filesystem::path file = folder / "arm.svg";
        draw(setup.getSolutionPath(), file);
        std::cout << "picture: " << file.string() << '\n';
    }
    return solved;
}

int main(int argc, char** argv)
{
    try
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
        return run(argc > 1 ? argv[1] : "out/demo") ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    catch (const std::exception& error)
    {
        std::cerr << "arm: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
