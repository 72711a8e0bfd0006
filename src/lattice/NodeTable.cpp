// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/NodeTable.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace specplan::lattice
{
namespace
{
constexpr std::size_t kMaxNodes = std::size_t{1} << 31;  // the upper half of NodeId marks motions in check ids

/// For rows of a few numbers a loop is faster than memcmp.
bool sameRow(const Coordinate* a, const Coordinate* b, std::size_t size) noexcept
{
    for (std::size_t i = 0; i < size; ++i)
        if (a[i] != b[i])
            return false;
    return true;
}
}  // namespace

NodeTable::NodeTable(std::size_t dimension)
    : dimension_(dimension), rows_(dimension), slots_(std::size_t{1} << kFirstBits)
{
}

std::size_t NodeTable::probe(const Coordinate* coordinates, std::uint64_t hash) const noexcept
{
    const std::size_t mask = slots_.size() - 1;
    std::size_t place = placeOf(tagOf(hash));
    while (slots_[place].node != kNoNode)
    {
        const Slot& slot = slots_[place];
        if (slot.tag == tagOf(hash) && sameRow(coordinates, rows_.row(slot.node), dimension_))
            break;
        place = (place + 1) & mask;
    }
    return place;
}

NodeId NodeTable::intern(const Coordinate* coordinates, std::uint64_t hash)
{
    std::size_t place = probe(coordinates, hash);
    if (slots_[place].node != kNoNode)
        return slots_[place].node;
    if (size() >= kMaxNodes)
        throw std::length_error("the lattice has more than 2^31 touched nodes; choose a coarser resolution");
    if ((size() + 1) * 2 > slots_.size())
    {
        grow();
        place = probe(coordinates, hash);
    }
    const auto node = static_cast<NodeId>(size());
    std::copy(coordinates, coordinates + dimension_, rows_.append());
    slots_[place] = {tagOf(hash), node};
    return node;
}

NodeId NodeTable::find(const Coordinate* coordinates) const noexcept
{
    return slots_[probe(coordinates, util::hashCoordinates({coordinates, dimension_}))].node;
}

/// Places go by the upper bits of the tag: so both tables are walked through in order and no row is looked at.
void NodeTable::grow()
{
    const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(slots_.size() * 2));
    --placeShift_;
    const std::size_t mask = slots_.size() - 1;
    for (const Slot& slot : old)
    {
        if (slot.node == kNoNode)
            continue;
        std::size_t place = placeOf(slot.tag);
        while (slots_[place].node != kNoNode)
            place = (place + 1) & mask;
        slots_[place] = slot;
    }
}
}  // namespace specplan::lattice
