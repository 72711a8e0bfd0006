// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/RotationFactor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

namespace specplan::lattice
{
namespace
{
/// Steps beyond this distance (more than 120 degrees) are left out: on the coarsest grid they would lead to the far
/// side.
constexpr double kFarthest = 1.1;
}  // namespace

RotationGrid::RotationGrid(Coordinate size) : size_(size)
{
    if (size < 1)
        throw std::invalid_argument("a grid of rotations needs a size of at least 1");
    for (Coordinate line = 0; line < size; ++line)
        lines_.push_back(std::tan(line * (std::numbers::pi / 4.0) / size));
    lines_.push_back(1.0);
}

void RotationGrid::makeCanonical(Coordinate* point) const noexcept
{
    for (int i = 0; i < 4; ++i)
    {
        if (point[i] == size_)
            return;
        if (point[i] == -size_)
            break;
    }
    for (int i = 0; i < 4; ++i)
        point[i] = -point[i];
}

Quaternion RotationGrid::rotation(const Coordinate* point) const noexcept
{
    Quaternion q{};
    double squared = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const double line = lines_[static_cast<std::size_t>(std::abs(point[i]))];
        q[i] = point[i] < 0 ? -line : line;
        squared += q[i] * q[i];
    }
    const double length = std::sqrt(squared);
    for (double& value : q)
        value /= length;
    return q;
}

std::array<double, 4> RotationGrid::place(const Quaternion& rotation) const noexcept
{
    double greatest = 0.0;
    for (const double value : rotation)
        greatest = std::max(greatest, std::abs(value));
    std::array<double, 4> place{};
    for (std::size_t i = 0; i < 4; ++i)
        place[i] = std::atan(rotation[i] / greatest) * (4.0 / std::numbers::pi) * size_;
    return place;
}

double rotationDistance(const Quaternion& a, const Quaternion& b) noexcept
{
    double dot = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
        dot += a[i] * b[i];
    dot = std::abs(dot);
    return dot > 1.0 - 1e-9 ? 0.0 : std::acos(dot);
}

RotationFactor::RotationFactor(const RotationGrid& grid, Coordinate stride, unsigned connectivity, double weight,
                               double longest)
    : grid_(grid), stride_(stride), weight_(weight), longest_(longest), offsets_(gridOffsets(4, connectivity))
{
    if (stride < 1 || grid.size() % stride != 0)
        throw std::invalid_argument("the stride of a grid of rotations has to divide its size");
}

bool RotationFactor::take(const Coordinate* from, std::uint32_t step, Coordinate* end, Taken& taken) const
{
    Coordinate greatest = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        end[i] = from[i] + offsets_[step].values[i] * stride_;
        greatest = std::max(greatest, std::abs(end[i]));
    }
    if (greatest != grid_.size())
        return false;  // off the surface
    grid_.makeCanonical(end);
    const double distance = rotationDistance(grid_.rotation(from), grid_.rotation(end));
    if (distance > kFarthest)
        return false;
    taken = {weight_ * distance, distance > longest_};
    return true;
}
}  // namespace specplan::lattice
