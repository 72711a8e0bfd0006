// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "specplan/lattice/Factor.h"

namespace specplan::lattice
{
/// A vehicle's plane: place and heading, and for each heading the motions that the vehicle can make from it, wherever
/// it stands. Coordinates: x, y, heading (0 to headings - 1).
///
/// Reference: M. Pivtoraiko, R. Knepper, A. Kelly, "Differentially constrained mobile robot motion planning in state
/// lattices", 2009.
class PrimitiveFactor : public Factor
{
public:
    struct Primitive
    {
        Coordinate dx;
        Coordinate dy;
        Coordinate heading;  ///< at the end
        Taken taken;
    };

    /// Where the lattice lies in the world: place = origin + x * u + y * v has to stay between low and high.
    struct Frame
    {
        std::array<double, 2> origin;
        std::array<double, 2> u;
        std::array<double, 2> v;
        std::array<double, 2> low;
        std::array<double, 2> high;
    };

    /// \param primitives for each heading; all headings must have some.
    /// \throws std::invalid_argument if a heading has none.
    PrimitiveFactor(const Frame& frame, std::vector<std::vector<Primitive>> primitives);

    [[nodiscard]] std::size_t dimension() const noexcept override
    {
        return 3;
    }

    [[nodiscard]] std::uint32_t steps() const noexcept override
    {
        return steps_;
    }

    [[nodiscard]] unsigned axes(std::uint32_t) const noexcept override
    {
        return 3;
    }

    bool take(const Coordinate* from, std::uint32_t step, Coordinate* end, Taken& taken) const override;

private:
    Frame frame_;
    std::vector<std::vector<Primitive>> primitives_;
    std::uint32_t steps_ = 0;
};

/// Place of lattice coordinates in the world.
[[nodiscard]] std::array<double, 2> placeOf(const PrimitiveFactor::Frame& frame, double x, double y) noexcept;
}  // namespace specplan::lattice
