// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/CarTable.h"

#include <limits>

namespace specplan::planner
{
using lattice::Coordinate;

namespace
{
constexpr std::size_t kMostNodes = 1 << 20;
/// Coordinates take 28 bits each, headings 8.
constexpr unsigned kBits = 28;
constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;

Coordinate unpack(std::uint64_t bits)
{
    const auto value = static_cast<Coordinate>(bits & kMask);
    return value >= (1 << (kBits - 1)) ? value - (1 << kBits) : value;
}
}  // namespace

CarTable::CarTable(const lattice::PrimitiveFactor::Frame& frame, const Primitives& primitives,
                   const std::vector<std::pair<std::vector<Coordinate>, double>>& entrances)
    : frame_(frame), reverse_(primitives.size())
{
    for (std::size_t from = 0; from < primitives.size(); ++from)
        for (const lattice::PrimitiveFactor::Primitive& motion : primitives[from])
            reverse_[static_cast<std::size_t>(motion.heading)].push_back(
                {-motion.dx, -motion.dy, static_cast<Coordinate>(from), motion.taken.cost});
    for (const auto& [node, length] : entrances)
        open_.emplace(length, keyOf(node[0], node[1], node[2]));
}

CarTable::Key CarTable::keyOf(Coordinate x, Coordinate y, Coordinate heading) noexcept
{
    return (static_cast<Key>(x) & kMask) | ((static_cast<Key>(y) & kMask) << kBits) |
           (static_cast<Key>(heading) << (2 * kBits));
}

bool CarTable::contains(Coordinate x, Coordinate y) const noexcept
{
    const std::array<double, 2> place = lattice::placeOf(frame_, x, y);
    return place[0] >= frame_.low[0] && place[0] <= frame_.high[0] && place[1] >= frame_.low[1] &&
           place[1] <= frame_.high[1];
}

void CarTable::expand(Key key, double length)
{
    const Coordinate x = unpack(key);
    const Coordinate y = unpack(key >> kBits);
    for (const Reverse& motion : reverse_[key >> (2 * kBits)])
    {
        const Key before = keyOf(x + motion.dx, y + motion.dy, motion.heading);
        if (contains(x + motion.dx, y + motion.dy) && closed_.count(before) == 0)
            open_.emplace(length + motion.length, before);
    }
}

double CarTable::lengthFrom(const Coordinate* node)
{
    const Key key = keyOf(node[0], node[1], node[2]);
    for (;;)
    {
        if (const auto found = closed_.find(key); found != closed_.end())
            return found->second;
        if (open_.empty())
            return std::numeric_limits<double>::infinity();
        if (closed_.size() >= kMostNodes)
            return open_.top().first;
        const auto [length, nearest] = open_.top();
        open_.pop();
        if (closed_.emplace(nearest, length).second)
            expand(nearest, length);
    }
}
}  // namespace specplan::planner
