// SPDX-License-Identifier: BSD-3-Clause
// An L-shaped body flies through two windows, one upright and one lying, and has to turn in between. The checker moves
// two FCL boxes; everything it shares between threads is constant.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include <specplan/planner/SpeculativeAStar.h>

#include "Drawing.h"
#include "Solid.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
using demo::Box;
using State = ob::SE3StateSpace::StateType;

/// The body where a state puts it: a long arm along x and a short one along z, metres.
std::vector<Box> bodyAt(const State& state)
{
    const ob::SO3StateSpace::StateType& q = state.rotation();
    const Eigen::Isometry3d frame =
        Eigen::Translation3d(state.getX(), state.getY(), state.getZ()) * Eigen::Quaterniond(q.w, q.x, q.y, q.z);
    return {{fcl::Boxd(1.2, 0.2, 0.2), frame * Eigen::Translation3d(0.0, 0.0, -0.25)},
            {fcl::Boxd(0.2, 0.2, 0.5), frame * Eigen::Translation3d(-0.5, 0.0, 0.1)}};
}

/// A wall at x = `x` with a window in it.
void addWall(std::vector<Box>& boxes, double x, double left, double right, double bottom, double top)
{
    const auto add = [&](double y0, double y1, double z0, double z1) {
        boxes.push_back(demo::boxBetween({x - 0.05, y0, z0}, {x + 0.05, y1, z1}));
    };
    add(-1.5, left, 0.0, 3.0);
    add(right, 1.5, 0.0, 3.0);
    add(left, right, 0.0, bottom);
    add(left, right, top, 3.0);
}

constexpr std::size_t kRoom = 6;  // obstacles around the room; the rest is inside

/// A room of 6 x 3 x 3 m and two walls across it.
std::vector<Box> makeObstacles()
{
    std::vector<Box> boxes;
    for (const double z : {-0.1, 3.0})
        boxes.push_back(demo::boxBetween({-3.1, -1.6, z}, {3.1, 1.6, z + 0.1}));
    for (const double y : {-1.6, 1.5})
        boxes.push_back(demo::boxBetween({-3.1, y, 0.0}, {3.1, y + 0.1, 3.0}));
    for (const double x : {-3.1, 3.0})
        boxes.push_back(demo::boxBetween({x, -1.5, 0.0}, {x + 0.1, 1.5, 3.0}));
    addWall(boxes, -0.8, -1.0, -0.6, 0.5, 1.5);
    addWall(boxes, 0.8, 0.1, 1.1, 1.8, 2.2);
    return boxes;
}

const std::vector<Box>& obstacles()
{
    static const std::vector<Box> boxes = makeObstacles();
    return boxes;
}

bool isValid(const ob::State* state)
{
    for (const Box& part : bodyAt(*state->as<State>()))
        for (const Box& obstacle : obstacles())
            if (demo::collide(part, obstacle))
                return false;
    return true;
}

og::SimpleSetup makeSetup()
{
    auto space = std::make_shared<ob::SE3StateSpace>();
    ob::RealVectorBounds bounds(3);
    bounds.low = {-3.0, -1.5, 0.0};
    bounds.high = {3.0, 1.5, 3.0};
    space->setBounds(bounds);

    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(isValid);
    ob::ScopedState<ob::SE3StateSpace> start(space), goal(space);
    start->setXYZ(-2.2, 0.4, 1.9);
    start->rotation().setAxisAngle(0.0, 0.0, 1.0, 1.2);
    goal->setXYZ(2.1, -0.7, 0.8);
    goal->rotation().setAxisAngle(0.0, 1.0, 0.0, -1.4);
    setup.setStartAndGoalStates(start, goal);
    return setup;
}

void draw(og::PathGeometric path, const std::filesystem::path& file)
{
    constexpr unsigned kShown = 40;
    struct View
    {
        int across, up;
    };
    constexpr std::array<View, 3> views{{{0, 1}, {0, 2}, {1, 2}}};
    path.interpolate(kShown);
    demo::Drawing drawing("An L-shaped body flies through two windows", {{"from above", -3.0, 3.0, -1.5, 1.5},
                                                                         {"from the side", -3.0, 3.0, 0.0, 3.0},
                                                                         {"from the front", -1.5, 1.5, 0.0, 3.0}});
    for (std::size_t panel = 0; panel < views.size(); ++panel)
    {
        const auto [across, up] = views[panel];
        for (std::size_t i = kRoom; i < obstacles().size(); ++i)
            drawing.polygon(panel, demo::outline(obstacles()[i], across, up), "fill=\"#3b3f45\" opacity=\"0.2\"");
        const std::size_t count = path.getStateCount();
        for (std::size_t i = 0; i < count; ++i)
        {
            const char* style = i == 0           ? "fill=\"#1a9641\" opacity=\"0.9\""
                                : i + 1 == count ? "fill=\"#d7191c\" opacity=\"0.9\""
                                                 : "fill=\"#3182bd\" opacity=\"0.25\"";
            for (const Box& part : bodyAt(*path.getState(static_cast<unsigned>(i))->as<State>()))
                drawing.polygon(panel, demo::outline(part, across, up), style);
        }
    }
    drawing.save(file);
}

bool run(const std::filesystem::path& folder)
{
    og::SimpleSetup setup = makeSetup();
    auto planner = std::make_shared<specplan::SpeculativeAStar>(setup.getSpaceInformation());
    planner->params().setParam("spacing", "0.15");  // of places, m; the windows leave the body 0.2 m
    setup.setPlanner(planner);
    const ob::PlannerStatus status = setup.solve(30.0);
    const bool solved = status == ob::PlannerStatus::EXACT_SOLUTION && setup.getSolutionPath().check();
    const specplan::SearchReport& report = planner->getReport();
    std::cout << "space  status                  length    checks  seconds   bound  refinements\n"
              << "SE3    " << std::left << std::setw(22) << status.asString() << std::right << std::fixed
              << std::setprecision(3) << std::setw(8) << report.cost << std::setw(10) << report.checksTotal
              << std::setw(9) << report.wallTime << std::setw(8) << std::setprecision(2) << report.bound
              << std::setw(13) << report.refinements << '\n';
    if (solved)
    {
        const std::filesystem::path file = folder / "rigid_body.svg";
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
        std::cerr << "rigid_body: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
