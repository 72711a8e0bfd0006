// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "specplan/lattice/Factor.h"
#include "specplan/lattice/Offsets.h"

namespace specplan::lattice
{
/// A unit quaternion, in the order x, y, z, w.
using Quaternion = std::array<double, 4>;

/// A grid of rotations: the integer points on the surface of the cube [-size, size]^4, opposite points being one.
///
/// Unit quaternions are the unit sphere in four dimensions, q and -q being the same rotation. The sphere is blown up to
/// a cube, and the cube's surface carries an integer grid; a grid line at k stands for tan(k / size * pi / 4), which
/// makes the cells nearly equal. There is no pole, and the grid of half the spacing contains this one: double the
/// numbers. The number of rotations is ((2 n + 1)^4 - (2 n - 1)^4) / 2 with n = size / stride: 40, 272, 2080, ... for
/// 1, 2, 4.
///
/// Idea: the cubed sphere (Ronchi, Iacono, Paolucci 1996), one dimension up.
class RotationGrid
{
public:
    /// \param size half an edge of the cube, in lattice units; at least 1.
    explicit RotationGrid(Coordinate size);

    [[nodiscard]] Coordinate size() const noexcept
    {
        return size_;
    }

    /// Chooses, of a point and its opposite, the one whose first coordinate of size `size` is positive.
    void makeCanonical(Coordinate* point) const noexcept;

    /// The rotation at a point.
    [[nodiscard]] Quaternion rotation(const Coordinate* point) const noexcept;

    /// Where a rotation lies on the cube: real coordinates, the greatest of which is `size`.
    [[nodiscard]] std::array<double, 4> place(const Quaternion& rotation) const noexcept;

private:
    Coordinate size_;
    std::vector<double> lines_;  ///< grid line, from 0 to size -> its place on the blown-up sphere
};

/// Angle between rotations as OMPL measures it: half the angle of the rotation between them, 0 to pi/2.
[[nodiscard]] double rotationDistance(const Quaternion& a, const Quaternion& b) noexcept;

/// Steps on a grid of rotations: to the points around, up to `connectivity` coordinates changed by one stride.
class RotationFactor : public Factor
{
public:
    /// \param stride units of a step; divides the size of the grid. \param connectivity 1 to 3. \param weight cost of a
    /// step by its rotationDistance. \param longest distance of a motion whose inside need not be checked.
    RotationFactor(const RotationGrid& grid, Coordinate stride, unsigned connectivity, double weight, double longest);

    [[nodiscard]] std::size_t dimension() const noexcept override
    {
        return 4;
    }

    [[nodiscard]] std::uint32_t steps() const noexcept override
    {
        return static_cast<std::uint32_t>(offsets_.size());
    }

    [[nodiscard]] unsigned axes(std::uint32_t step) const noexcept override
    {
        return offsets_[step].axes;
    }

    bool take(const Coordinate* from, std::uint32_t step, Coordinate* end, Taken& taken) const override;

private:
    RotationGrid grid_;
    Coordinate stride_;
    double weight_;
    double longest_;
    std::vector<Offset> offsets_;
};
}  // namespace specplan::lattice
