// SPDX-License-Identifier: BSD-3-Clause
// A car leaves its bay in a car park and drives into another one: as a free body (SE2), as a car that only drives
// forward (Dubins), and as one that also backs up (Reeds-Shepp). The checker is plain C++.
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include <specplan/planner/SpeculativeAStar.h>

#include "Drawing.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
using demo::Point;

constexpr double kWidth = 40.0;         // of the car park, metres
constexpr double kDepth = 30.0;         // of the car park, metres
constexpr double kTurningRadius = 5.0;  // metres

/// A rectangle: its middle, half its length and width, and the way it points.
struct Rectangle
{
    Point middle;
    double halfLength, halfWidth;
    double cosine, sine;

    std::array<Point, 4> corners() const
    {
        std::array<Point, 4> corners{{{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}};
        for (Point& corner : corners)
        {
            const double along = corner[0] * halfLength;
            const double across = corner[1] * halfWidth;
            corner = {middle[0] + cosine * along - sine * across, middle[1] + sine * along + cosine * across};
        }
        return corners;
    }

    /// Half of the rectangle's shadow on a line in the direction (x, y).
    double halfShadow(double x, double y) const
    {
        return halfLength * std::abs(cosine * x + sine * y) + halfWidth * std::abs(cosine * y - sine * x);
    }
};

/// Separating axes: two rectangles are apart if their shadows on the direction of some side are.
bool overlap(const Rectangle& a, const Rectangle& b)
{
    const double dx = b.middle[0] - a.middle[0];
    const double dy = b.middle[1] - a.middle[1];
    for (const Point& axis :
         {Point{a.cosine, a.sine}, Point{-a.sine, a.cosine}, Point{b.cosine, b.sine}, Point{-b.sine, b.cosine}})
        if (std::abs(dx * axis[0] + dy * axis[1]) > a.halfShadow(axis[0], axis[1]) + b.halfShadow(axis[0], axis[1]))
            return false;
    return true;
}

/// The car, 4 m by 1.8 m. Its place is the middle of the rear axle, 0.8 m from its back.
Rectangle carAt(const ob::State* state)
{
    const auto* place = state->as<ob::SE2StateSpace::StateType>();
    const double cosine = std::cos(place->getYaw());
    const double sine = std::sin(place->getYaw());
    return {{place->getX() + 1.2 * cosine, place->getY() + 1.2 * sine}, 2.0, 0.9, cosine, sine};
}

/// Two rows of bays along the walls, two back to back between them, and a lorry that blocks the way around on the
/// right.
std::vector<Rectangle> makeObstacles()
{
    const auto parked = [](double x, double y) { return Rectangle{{x, y}, 2.0, 0.9, 0.0, 1.0}; };
    std::vector<Rectangle> obstacles{{{34.5, 15.0}, 5.4, 1.25, 1.0, 0.0}};
    for (int bay = 0; bay < 10; ++bay)
    {
        const double x = 6.5 + 3.0 * bay;
        if (bay != 3)  // the car's own
            obstacles.push_back(parked(x, 2.5));
        if (bay != 5 && bay != 6)  // the free ones
            obstacles.push_back(parked(x, 27.5));
    }
    for (int bay = 0; bay < 6; ++bay)
        for (const double y : {12.7, 17.3})
            obstacles.push_back(parked(12.5 + 3.0 * bay, y));
    return obstacles;
}

const std::vector<Rectangle>& obstacles()
{
    static const std::vector<Rectangle> rectangles = makeObstacles();
    return rectangles;
}

bool isValid(const ob::State* state)
{
    const Rectangle car = carAt(state);
    for (const Point& corner : car.corners())
        if (corner[0] < 0.0 || corner[0] > kWidth || corner[1] < 0.0 || corner[1] > kDepth)
            return false;
    for (const Rectangle& obstacle : obstacles())
        if (overlap(car, obstacle))
            return false;
    return true;
}

og::SimpleSetup makeSetup(const std::shared_ptr<ob::SE2StateSpace>& space)
{
    ob::RealVectorBounds bounds(2);
    bounds.low = {0.0, 0.0};
    bounds.high = {kWidth, kDepth};
    space->setBounds(bounds);

    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(isValid);
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.004);  // 20 cm
    ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
    start->setXY(15.5, 1.3);
    start->setYaw(std::numbers::pi / 2.0);
    goal->setXY(24.5, 26.3);
    goal->setYaw(std::numbers::pi / 2.0);
    setup.setStartAndGoalStates(start, goal);
    return setup;
}

void drawRectangle(demo::Drawing& drawing, const Rectangle& rectangle, const std::string& style)
{
    const std::array<Point, 4> corners = rectangle.corners();
    drawing.polygon(0, {corners.begin(), corners.end()}, style);
}

void draw(const std::string& name, og::PathGeometric path, const std::filesystem::path& file)
{
    demo::Drawing drawing(name, {{"the car every 1.5 m, and the way of its rear axle", 0.0, kWidth, 0.0, kDepth}});
    for (const Rectangle& obstacle : obstacles())
        drawRectangle(drawing, obstacle, "fill=\"#3b3f45\" opacity=\"0.6\"");
    path.interpolate(static_cast<unsigned>(path.length() / 0.1) + 2);
    const std::size_t last = path.getStateCount() - 1;
    demo::Points axle;
    for (std::size_t i = 0; i <= last; ++i)
    {
        const ob::State* state = path.getState(static_cast<unsigned>(i));
        const auto* place = state->as<ob::SE2StateSpace::StateType>();
        axle.push_back({place->getX(), place->getY()});
        if (i % 15 == 0 || i == last)
            drawRectangle(drawing, carAt(state),
                          i == 0 ? "fill=\"#1a9641\" opacity=\"0.7\""
                          : i == last
                              ? "fill=\"#d7191c\" opacity=\"0.7\""
                              : "fill=\"#3182bd\" fill-opacity=\"0.12\" stroke=\"#3182bd\" stroke-width=\"0.05\"");
    }
    drawing.line(0, axle, "stroke=\"#d7191c\" stroke-width=\"0.12\"");
    drawing.save(file);
}

/// Plans with default parameters, prints a row, and draws the path. \return whether there is one that holds.
bool plan(const std::string& name, const std::shared_ptr<ob::SE2StateSpace>& space, const std::filesystem::path& file)
{
    og::SimpleSetup setup = makeSetup(space);
    auto planner = std::make_shared<specplan::SpeculativeAStar>(setup.getSpaceInformation());
    setup.setPlanner(planner);
    const ob::PlannerStatus status = setup.solve(30.0);
    const bool solved = status == ob::PlannerStatus::EXACT_SOLUTION && setup.getSolutionPath().check();
    const specplan::SearchReport& report = planner->getReport();
    std::cout << std::left << std::setw(14) << name << std::setw(22) << status.asString() << std::right << std::fixed
              << std::setprecision(2) << std::setw(8) << report.cost << std::setw(9) << report.checksTotal
              << std::setw(9) << std::setprecision(3) << report.wallTime << std::setw(7) << std::setprecision(2)
              << report.bound << "   " << (solved ? file.string() : "no path that holds") << std::endl;
    if (solved)
        draw(name, setup.getSolutionPath(), file);
    return solved;
}

bool run(const std::filesystem::path& folder)
{
    std::cout << "space         status                  length   checks  seconds  bound   picture\n";
    const bool se2 = plan("SE2", std::make_shared<ob::SE2StateSpace>(), folder / "car_se2.svg");
    const bool dubins =
        plan("Dubins", std::make_shared<ob::DubinsStateSpace>(kTurningRadius), folder / "car_dubins.svg");
    const bool reedsShepp =
        plan("Reeds-Shepp", std::make_shared<ob::ReedsSheppStateSpace>(kTurningRadius), folder / "car_reeds_shepp.svg");
    return se2 && dubins && reedsShepp;
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
        std::cerr << "car: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
