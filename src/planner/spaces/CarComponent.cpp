// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/CarComponent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "specplan/planner/spaces/CarPrimitives.h"
#include "specplan/planner/spaces/CarTable.h"

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::Coordinate;

namespace
{
constexpr double kHeadingStep = 2.0 * std::numbers::pi / CarComponent::kHeadings;
/// A state off the lattice is joined to this many nodes.
constexpr std::size_t kMaxCarCorners = 64;
/// Estimates are finite, also where no way leads to the goal.
constexpr double kFar = 1e12;
/// Curves longer than this many times the straight distance make a loop.
constexpr double kLoop = 1.15;

void setPose(ob::State* state, double x, double y, double yaw)
{
    auto* pose = state->as<ob::SE2StateSpace::StateType>();
    pose->setXY(x, y);
    const double wrapped = std::remainder(yaw, 2.0 * std::numbers::pi);
    pose->setYaw(wrapped < std::numbers::pi ? wrapped : -std::numbers::pi);  // SO2 is half open
}
}  // namespace

CarComponent::CarComponent(ob::StateSpacePtr space, std::string name, double spacing, const ob::State* origin,
                           const LatticeOptions& options)
    : space_(std::move(space)),
      name_(std::move(name)),
      options_(options),
      heading_(origin->as<ob::SE2StateSpace::StateType>()->getYaw()),
      unit_(spacing / (Coordinate{1} << options.levels)),
      stride_(Coordinate{1} << options.levels),
      here_(space_),
      there_(space_)
{
    const auto* pose = origin->as<ob::SE2StateSpace::StateType>();
    const ob::RealVectorBounds& bounds = space_->as<ob::SE2StateSpace>()->getBounds();
    const double c = std::cos(heading_) * unit_;
    const double s = std::sin(heading_) * unit_;
    frame_ = {{pose->getX(), pose->getY()},
              {c, s},
              {-s, c},
              {bounds.low[0], bounds.low[1]},
              {bounds.high[0], bounds.high[1]}};
    const double radius = turningRadius(*space_);
    turn_ = radius * kHeadingStep;
    // A symmetric Dubins space drives each curve forward or backward as a whole, and two curves may beat the one.
    if (dynamic_cast<const ob::DubinsStateSpace*>(space_.get()) != nullptr && space_->hasSymmetricDistance())
        shortest_ = std::make_shared<ob::ReedsSheppStateSpace>(radius);
    else
        shortest_ = space_;
    primitives_ = makePrimitives();
}

/// Steps that a motion may lead away along an axis: far enough to turn by one heading.
Coordinate CarComponent::reach() const
{
    return static_cast<Coordinate>(std::clamp(std::ceil(4.0 * turn_ / (unit_ * stride_)), 4.0, 12.0));
}

CarComponent::Primitives CarComponent::makePrimitives() const
{
    const auto pose = [this](ob::State* state, Coordinate x, Coordinate y, Coordinate heading)
    { setPose(state, x * stride_ * unit_, y * stride_ * unit_, heading * kHeadingStep); };
    const auto length = [&](const CarMotion& motion)
    {
        pose(here_.get(), 0, 0, motion.from);
        pose(there_.get(), motion.dx, motion.dy, motion.to);
        return space_->distance(here_.get(), there_.get());
    };
    const std::vector<CarMotion> motions = carPrimitives(kHeadings, reach(), unit_ * stride_, kLoop, length);
    Primitives primitives(kHeadings);
    for (const CarMotion& motion : motions)
        primitives[static_cast<std::size_t>(motion.from)].push_back(
            {motion.dx * stride_,
             motion.dy * stride_,
             motion.to,
             {options_.weight * motion.length, motion.length > options_.longest}});
    return primitives;
}

std::unique_ptr<const lattice::Factor> CarComponent::factor(bool discreteMotions) const
{
    Primitives primitives = primitives_;
    for (auto& ofHeading : primitives)
        for (lattice::PrimitiveFactor::Primitive& primitive : ofHeading)
            primitive.taken.checked = primitive.taken.checked || !discreteMotions;
    return std::make_unique<lattice::PrimitiveFactor>(frame_, std::move(primitives));
}

void CarComponent::refine()
{
    if (!canRefine())
        return;
    stride_ /= 2;
    primitives_ = makePrimitives();
}

double CarComponent::coarseness() const
{
    return options_.longest > 0.0 ? unit_ * stride_ / options_.longest : std::numeric_limits<double>::infinity();
}

void CarComponent::write(const Coordinate* node, ob::State* state) const
{
    const std::array<double, 2> place = lattice::placeOf(frame_, node[0], node[1]);
    if (node[2] == 0)  // not a bit away from the start's heading
    {
        auto* pose = state->as<ob::SE2StateSpace::StateType>();
        pose->setXY(place[0], place[1]);
        pose->setYaw(heading_);
        return;
    }
    setPose(state, place[0], place[1], heading_ + node[2] * kHeadingStep);
}

std::vector<Component::Coordinates> CarComponent::corners(const ob::State* state, Joint joint) const
{
    const auto* pose = state->as<ob::SE2StateSpace::StateType>();
    const double dx = pose->getX() - frame_.origin[0];
    const double dy = pose->getY() - frame_.origin[1];
    const double step = unit_ * stride_;
    const auto atX = static_cast<Coordinate>(std::lround((dx * frame_.u[0] + dy * frame_.u[1]) / (unit_ * step)));
    const auto atY = static_cast<Coordinate>(std::lround((dx * frame_.v[0] + dy * frame_.v[1]) / (unit_ * step)));
    std::vector<std::pair<double, Coordinates>> found;
    for (Coordinate x = atX - reach(); x <= atX + reach(); ++x)
        for (Coordinate y = atY - reach(); y <= atY + reach(); ++y)
        {
            const std::array<double, 2> place = lattice::placeOf(frame_, x * stride_, y * stride_);
            if (place[0] < frame_.low[0] || place[0] > frame_.high[0] || place[1] < frame_.low[1] ||
                place[1] > frame_.high[1])
                continue;
            const double straight = std::hypot(place[0] - pose->getX(), place[1] - pose->getY());
            for (Coordinate heading = 0; heading < kHeadings; ++heading)
            {
                Coordinates node{x * stride_, y * stride_, heading};
                write(node.data(), here_.get());
                const double length = joint == Joint::Entering ? space_->distance(here_.get(), state)
                                                               : space_->distance(state, here_.get());
                if (length <= kLoop * straight + step * 1e-9)
                    found.emplace_back(length, std::move(node));
            }
        }
    std::ranges::sort(found);
    if (found.size() > kMaxCarCorners)
        found.resize(kMaxCarCorners);
    std::vector<Coordinates> corners;
    corners.reserve(found.size());
    for (auto& [length, node] : found)
        corners.push_back(std::move(node));
    if (!found.empty() && found.front().first <= step * 1e-9)
        corners.resize(1);  // the state is a node
    return corners;
}

Component::Target CarComponent::target(const ob::State* state, bool exactly) const
{
    const auto* pose = state->as<ob::SE2StateSpace::StateType>();
    Target target{{pose->getX(), pose->getY(), pose->getYaw()}, nullptr, 0.0};
    if (!exactly)
        return target;
    std::vector<std::pair<Coordinates, double>> entrances;
    for (const Coordinates& corner : corners(state, Joint::Entering))
    {
        write(corner.data(), here_.get());
        entrances.emplace_back(corner, options_.weight * space_->distance(here_.get(), state));
    }
    target.table = std::make_shared<CarTable>(frame_, primitives_, entrances);
    return target;
}

double CarComponent::lowerBound(const Coordinate* node, const Target& target) const
{
    if (target.table)
        return std::min(target.table->lengthFrom(node), kFar);
    write(node, here_.get());
    setPose(there_.get(), target.values[0], target.values[1], target.values[2]);
    return options_.weight * shortest_->distance(here_.get(), there_.get());
}

double CarComponent::nodes() const
{
    const double area = (frame_.high[0] - frame_.low[0]) * (frame_.high[1] - frame_.low[1]);
    return area / (unit_ * stride_ * unit_ * stride_) * kHeadings;
}

void CarComponent::describe(std::ostream& out) const
{
    std::size_t motions = 0;
    for (const auto& ofHeading : primitives_)
        motions += ofHeading.size();
    out << "  " << name_ << ": x " << frame_.low[0] << " to " << frame_.high[0] << ", y " << frame_.low[1] << " to "
        << frame_.high[1] << ", spacing " << unit_ * stride_ << ", " << kHeadings << " headings, "
        << static_cast<double>(motions) / kHeadings << " motions each\n";
}
}  // namespace specplan::planner
