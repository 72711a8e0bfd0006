// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/RotationComponent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <ompl/base/spaces/SO3StateSpace.h>

#include "RoundingSlack.h"

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::Coordinate;
using lattice::Quaternion;

namespace
{
Quaternion quaternionOf(const ob::State* state)
{
    const auto* q = state->as<ob::SO3StateSpace::StateType>();
    return {q->x, q->y, q->z, q->w};
}

/// The rotation b followed by the rotation a.
Quaternion product(const Quaternion& a, const Quaternion& b)
{
    return {
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

/// The grid is turned so that w is the first axis: the start's own rotation is the point (size, 0, 0, 0).
Quaternion wFirst(const Quaternion& q)
{
    return {q[3], q[0], q[1], q[2]};
}

Quaternion wLast(const Quaternion& q)
{
    return {q[1], q[2], q[3], q[0]};
}
}  // namespace

RotationComponent::RotationComponent(std::string name, Coordinate cells, const ob::State* origin,
                                     const LatticeOptions& options)
    : name_(std::move(name)),
      options_(options),
      origin_(quaternionOf(origin)),
      grid_(cells << options.levels),
      stride_(Coordinate{1} << options.levels)
{
    options_.connectivity = std::min(options.connectivity, 3U);
}

std::unique_ptr<const lattice::Factor> RotationComponent::factor(bool discreteMotions) const
{
    return std::make_unique<lattice::RotationFactor>(grid_, stride_, options_.connectivity, options_.weight,
                                                     discreteMotions ? options_.longest : -1.0);
}

void RotationComponent::refine()
{
    stride_ = std::max(stride_ / 2, 1);
}

double RotationComponent::coarseness() const
{
    const double step = stride_ * std::numbers::pi / 4.0 / grid_.size();
    return options_.longest > 0.0 ? step / options_.longest : std::numeric_limits<double>::infinity();
}

void RotationComponent::write(const Coordinate* node, ob::State* state) const
{
    const Quaternion q = product(origin_, wLast(grid_.rotation(node)));
    auto* rotation = state->as<ob::SO3StateSpace::StateType>();
    rotation->x = q[0];
    rotation->y = q[1];
    rotation->z = q[2];
    rotation->w = q[3];
}

Quaternion RotationComponent::relative(const ob::State* state) const
{
    const Quaternion inverse{-origin_[0], -origin_[1], -origin_[2], origin_[3]};
    return wFirst(product(inverse, quaternionOf(state)));
}

std::vector<Component::Coordinates> RotationComponent::corners(const ob::State* state, Joint) const
{
    const Quaternion rotation = relative(state);
    const std::array<double, 4> place = grid_.place(rotation);
    Coordinates nearest(4);
    Coordinates other(4);
    for (std::size_t i = 0; i < 4; ++i)
    {
        const double steps = place[i] / stride_;
        const double rounded = std::round(steps);
        const double rest = steps - rounded;
        nearest[i] = static_cast<Coordinate>(rounded) * stride_;
        other[i] = nearest[i] + (std::abs(rest) < kRoundingSlack ? 0 : (rest > 0.0 ? stride_ : -stride_));
        other[i] = std::clamp(other[i], -grid_.size(), grid_.size());
    }
    std::vector<Coordinates> corners{nearest};
    for (std::size_t i = 0; i < 4; ++i)
    {
        const std::size_t before = corners.size();
        for (std::size_t k = 0; other[i] != nearest[i] && k < before; ++k)
        {
            Coordinates corner = corners[k];
            corner[i] = other[i];
            corners.push_back(std::move(corner));
        }
    }
    for (Coordinates& corner : corners)
        grid_.makeCanonical(corner.data());
    std::ranges::stable_sort(corners, {},
                             [&](const Coordinates& corner)
                             { return lattice::rotationDistance(grid_.rotation(corner.data()), rotation); });
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

Component::Target RotationComponent::target(const ob::State* state, bool) const
{
    const Quaternion rotation = relative(state);
    return {{rotation.begin(), rotation.end()}, nullptr, 0.0};
}

double RotationComponent::lowerBound(const Coordinate* node, const Target& target) const
{
    const Quaternion goal{target.values[0], target.values[1], target.values[2], target.values[3]};
    return options_.weight * lattice::rotationDistance(grid_.rotation(node), goal);
}

double RotationComponent::nodes() const
{
    const double n = static_cast<double>(grid_.size()) / stride_;
    return (std::pow(2.0 * n + 1.0, 4.0) - std::pow(2.0 * n - 1.0, 4.0)) / 2.0;
}

void RotationComponent::describe(std::ostream& out) const
{
    out << "  " << name_ << ": all rotations, " << nodes() << " of them, " << 90.0 * stride_ / grid_.size()
        << " degrees apart\n";
}
}  // namespace specplan::planner
