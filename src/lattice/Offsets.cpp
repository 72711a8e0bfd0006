// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/Offsets.h"

#include <stdexcept>

namespace specplan::lattice
{
namespace
{
constexpr std::size_t kMaxOffsets = 65536;

void extend(Offset& offset, std::size_t axis, unsigned connectivity, std::vector<Offset>& out)
{
    if (axis == offset.values.size())
    {
        if (offset.axes == 0)
            return;
        if (out.size() == kMaxOffsets)
            throw std::invalid_argument("a node has more than 65536 neighbours; choose a smaller connectivity");
        out.push_back(offset);
        return;
    }
    for (const Coordinate value : {-1, 0, 1})
    {
        const unsigned changes = value != 0 ? 1 : 0;
        if (offset.axes + changes > connectivity)
            continue;
        offset.values[axis] = value;
        offset.axes += changes;
        extend(offset, axis + 1, connectivity, out);
        offset.axes -= changes;
    }
    offset.values[axis] = 0;
}
}  // namespace

std::vector<Offset> gridOffsets(std::size_t dimension, unsigned connectivity)
{
    std::vector<Offset> offsets;
    Offset offset{std::vector<Coordinate>(dimension, 0), 0};
    extend(offset, 0, connectivity, offsets);
    return offsets;
}
}  // namespace specplan::lattice
