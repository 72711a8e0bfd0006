// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/PrimitiveFactor.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace specplan::lattice
{
PrimitiveFactor::PrimitiveFactor(const Frame& frame, std::vector<std::vector<Primitive>> primitives)
    : frame_(frame), primitives_(std::move(primitives))
{
    for (std::size_t heading = 0; heading < primitives_.size(); ++heading)
    {
        if (primitives_[heading].empty())
            throw std::invalid_argument("heading " + std::to_string(heading) + " has no motions");
        steps_ = std::max(steps_, static_cast<std::uint32_t>(primitives_[heading].size()));
    }
}

bool PrimitiveFactor::take(const Coordinate* from, std::uint32_t step, Coordinate* end, Taken& taken) const
{
    const std::vector<Primitive>& all = primitives_[static_cast<std::size_t>(from[2])];
    if (step >= all.size())
        return false;
    const Primitive& primitive = all[step];
    end[0] = from[0] + primitive.dx;
    end[1] = from[1] + primitive.dy;
    end[2] = primitive.heading;
    const std::array<double, 2> place = placeOf(frame_, end[0], end[1]);
    for (std::size_t axis = 0; axis < 2; ++axis)
        if (place[axis] < frame_.low[axis] || place[axis] > frame_.high[axis])
            return false;
    taken = primitive.taken;
    return true;
}

std::array<double, 2> placeOf(const PrimitiveFactor::Frame& frame, double x, double y) noexcept
{
    return {frame.origin[0] + x * frame.u[0] + y * frame.v[0], frame.origin[1] + x * frame.u[1] + y * frame.v[1]};
}
}  // namespace specplan::lattice
