// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/AxesFactor.h"

#include <stdexcept>

#include "specplan/lattice/Offsets.h"

namespace specplan::lattice
{
AxesFactor::AxesFactor(std::vector<Axis> axes, unsigned connectivity,
                       const std::function<double(std::span<const Coordinate>)>& cost,
                       const std::function<bool(std::span<const Coordinate>)>& checked)
    : axes_(std::move(axes))
{
    if (axes_.empty())
        throw std::invalid_argument("a lattice needs at least one axis");
    for (Offset& offset : gridOffsets(axes_.size(), connectivity))
    {
        bool stands = false;
        for (std::size_t axis = 0; axis < axes_.size(); ++axis)
        {
            stands = stands || (offset.values[axis] != 0 && axes_[axis].lower == axes_[axis].upper);
            offset.values[axis] *= axes_[axis].stride;
        }
        if (stands)
            continue;
        patterns_.push_back({{cost(offset.values), checked(offset.values)}, offset.axes});
        offsets_.insert(offsets_.end(), offset.values.begin(), offset.values.end());
    }
}

bool AxesFactor::take(const Coordinate* from, std::uint32_t step, Coordinate* end, Taken& taken) const
{
    const std::size_t n = axes_.size();
    const Coordinate* offset = &offsets_[step * n];
    for (std::size_t i = 0; i < n; ++i)
    {
        const Axis& axis = axes_[i];
        end[i] = from[i] + offset[i];
        if (axis.period > 0)
            end[i] = (end[i] % axis.period + axis.period) % axis.period;
        else if (end[i] < axis.lower || end[i] > axis.upper)
            return false;
    }
    taken = patterns_[step].taken;
    return true;
}
}  // namespace specplan::lattice
