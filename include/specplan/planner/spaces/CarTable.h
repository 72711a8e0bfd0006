// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "specplan/lattice/PrimitiveFactor.h"

namespace specplan::planner
{
/// Exact lengths of the ways from nodes of a car's lattice to a goal where there are no obstacles: Dijkstra's algorithm
/// from the goal backwards, resumed whenever it has not come to a node yet.
///
/// Beyond some number of nodes it stops; what lies farther away than that is only known to be farther away.
///
/// Reference: D. Silver, "Cooperative Pathfinding", 2005 (reverse resumable A*).
///
/// Threads: search thread.
class CarTable
{
public:
    using Primitives = std::vector<std::vector<lattice::PrimitiveFactor::Primitive>>;

    /// \param frame bounds of the lattice. \param entrances nodes that are joined to the goal, and at what length.
    CarTable(const lattice::PrimitiveFactor::Frame& frame, const Primitives& primitives,
             const std::vector<std::pair<std::vector<lattice::Coordinate>, double>>& entrances);

    /// Length of the shortest way from a node, or a length that it has at least; infinite if there is none.
    [[nodiscard]] double lengthFrom(const lattice::Coordinate* node);

private:
    using Key = std::uint64_t;

    /// A motion as seen from its end.
    struct Reverse
    {
        lattice::Coordinate dx;
        lattice::Coordinate dy;
        lattice::Coordinate heading;  ///< at its beginning
        double length;
    };

    [[nodiscard]] static Key keyOf(lattice::Coordinate x, lattice::Coordinate y, lattice::Coordinate heading) noexcept;
    [[nodiscard]] bool contains(lattice::Coordinate x, lattice::Coordinate y) const noexcept;
    void expand(Key key, double length);

    lattice::PrimitiveFactor::Frame frame_;
    std::vector<std::vector<Reverse>> reverse_;  ///< by the heading at the end
    std::unordered_map<Key, double> closed_;
    std::priority_queue<std::pair<double, Key>, std::vector<std::pair<double, Key>>, std::greater<>> open_;
};
}  // namespace specplan::planner
