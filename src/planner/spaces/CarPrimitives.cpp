// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/CarPrimitives.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::Coordinate;

namespace
{
/// A motion is left out if two others make the same way at no more than this times its length.
constexpr double kSameLength = 1.1;

/// The same motion, a quarter turn further.
CarMotion turned(const CarMotion& motion, Coordinate headings)
{
    const Coordinate quarter = headings / 4;
    return {(motion.from + quarter) % headings, -motion.dy, motion.dx, (motion.to + quarter) % headings, motion.length};
}

/// Shortest known way from a heading at (0, 0) to a place nearby and a heading.
class Ways
{
public:
    Ways(Coordinate headings, Coordinate reach)
        : headings_(headings),
          reach_(reach),
          length_(static_cast<std::size_t>(headings * (2 * reach + 1) * (2 * reach + 1) * headings),
                  std::numeric_limits<double>::infinity())
    {
    }

    [[nodiscard]] bool holds(Coordinate dx, Coordinate dy) const
    {
        return std::abs(dx) <= reach_ && std::abs(dy) <= reach_;
    }

    double& at(Coordinate from, Coordinate dx, Coordinate dy, Coordinate to)
    {
        const auto width = 2 * static_cast<std::size_t>(reach_) + 1;
        const auto cell = static_cast<std::size_t>(dx + reach_) * width + static_cast<std::size_t>(dy + reach_);
        const std::size_t entry = static_cast<std::size_t>(from) * width * width + cell;
        return length_[entry * static_cast<std::size_t>(headings_) + static_cast<std::size_t>(to)];
    }

private:
    Coordinate headings_;
    Coordinate reach_;
    std::vector<double> length_;
};

std::vector<CarMotion> candidates(Coordinate headings, Coordinate reach, double step, double loop,
                                  const std::function<double(const CarMotion&)>& length)
{
    std::vector<CarMotion> all;
    for (Coordinate from = 0; from < headings / 4; ++from)
        for (Coordinate dx = -reach; dx <= reach; ++dx)
            for (Coordinate dy = -reach; dy <= reach; ++dy)
                for (Coordinate to = 0; to < headings; ++to)
                {
                    const double straight = step * std::hypot(dx, dy);
                    if (straight == 0.0 || straight > reach * step)
                        continue;
                    CarMotion motion{from, dx, dy, to, 0.0};
                    motion.length = length(motion);
                    if (motion.length > loop * straight)
                        continue;
                    for (int quarter = 0; quarter < 4; ++quarter)
                    {
                        all.push_back(motion);
                        motion = turned(motion, headings);
                    }
                }
    std::ranges::sort(all, {}, [](const CarMotion& m) { return std::tuple(m.length, m.from, m.dx, m.dy, m.to); });
    return all;
}
}  // namespace

std::vector<CarMotion> carPrimitives(Coordinate headings, Coordinate reach, double step, double loop,
                                     const std::function<double(const CarMotion&)>& length)
{
    Ways ways(headings, reach);
    std::vector<CarMotion> kept;
    for (const CarMotion& motion : candidates(headings, reach, step, loop, length))
    {
        double composed = std::numeric_limits<double>::infinity();
        for (const CarMotion& first : kept)
        {
            const Coordinate dx = motion.dx - first.dx;
            const Coordinate dy = motion.dy - first.dy;
            if (first.from == motion.from && ways.holds(dx, dy))
                composed = std::min(composed, first.length + ways.at(first.to, dx, dy, motion.to));
        }
        if (composed > kSameLength * motion.length)
        {
            kept.push_back(motion);
            composed = motion.length;
        }
        ways.at(motion.from, motion.dx, motion.dy, motion.to) = composed;
    }
    return kept;
}

double turningRadius(const ob::StateSpace& space)
{
    const auto turnInPlace = [](const ob::StateSpace& plane)
    {
        ob::State* here = plane.allocState();
        ob::State* there = plane.allocState();
        for (ob::State* state : {here, there})
            state->as<ob::SE2StateSpace::StateType>()->setXY(0.0, 0.0);
        here->as<ob::SE2StateSpace::StateType>()->setYaw(0.0);
        there->as<ob::SE2StateSpace::StateType>()->setYaw(std::numbers::pi / 2.0);
        const double length = plane.distance(here, there);
        plane.freeState(here);
        plane.freeState(there);
        return length;
    };
    if (dynamic_cast<const ob::DubinsStateSpace*>(&space) != nullptr)
        return turnInPlace(space) / turnInPlace(ob::DubinsStateSpace(1.0));
    return turnInPlace(space) / turnInPlace(ob::ReedsSheppStateSpace(1.0));
}
}  // namespace specplan::planner
