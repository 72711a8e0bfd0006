// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "specplan/util/Hash.h"
#include "specplan/util/SegmentedRows.h"

namespace specplan::lattice
{
/// Dense number of a lattice node, in order of first touch.
using NodeId = std::uint32_t;
inline constexpr NodeId kNoNode = std::numeric_limits<NodeId>::max();

/// One axis of a node's place on the lattice, in lattice steps.
using Coordinate = std::int32_t;

/// Gives each coordinate vector that is met a dense number and remembers it (hash table with open addressing).
///
/// Threads: one owner interns. Rows of nodes already handed over may be read by others meanwhile.
class NodeTable
{
public:
    /// \param dimension number of coordinates of a node, at least 1.
    explicit NodeTable(std::size_t dimension);

    [[nodiscard]] std::size_t dimension() const noexcept
    {
        return dimension_;
    }

    /// Number of nodes interned so far.
    [[nodiscard]] std::size_t size() const noexcept
    {
        return rows_.size();
    }

    /// The node at these coordinates (`dimension()` of them), made on first touch.
    /// \throws std::length_error beyond 2^31 nodes.
    NodeId intern(const Coordinate* coordinates)
    {
        return intern(coordinates, hashOf(coordinates));
    }

    /// The same in three steps, for whoever has many to look up: most of the time goes into waiting for memory, and
    /// between the steps there is time for others.
    [[nodiscard]] std::uint64_t hashOf(const Coordinate* coordinates) const noexcept
    {
        const std::uint64_t hash = util::hashCoordinates({coordinates, dimension_});
        __builtin_prefetch(&slots_[placeOf(tagOf(hash))]);
        return hash;
    }

    void fetchRow(std::uint64_t hash) const noexcept
    {
        if (const Slot& slot = slots_[placeOf(tagOf(hash))]; slot.node != kNoNode)
            __builtin_prefetch(rows_.row(slot.node));
    }

    NodeId intern(const Coordinate* coordinates, std::uint64_t hash);

    /// The node at these coordinates, or kNoNode if it was never touched.
    [[nodiscard]] NodeId find(const Coordinate* coordinates) const noexcept;

    [[nodiscard]] std::span<const Coordinate> coordinates(NodeId node) const noexcept
    {
        return {rows_.row(node), dimension_};
    }

private:
    struct Slot
    {
        std::uint32_t tag = 0;  ///< upper half of the hash: spares most look-ups of the row
        NodeId node = kNoNode;
    };

    static constexpr unsigned kFirstBits = 12;

    [[nodiscard]] static std::uint32_t tagOf(std::uint64_t hash) noexcept
    {
        return static_cast<std::uint32_t>(hash >> 32);
    }

    /// Where a slot with this tag is looked for first.
    [[nodiscard]] std::size_t placeOf(std::uint32_t tag) const noexcept
    {
        return tag >> placeShift_;
    }

    [[nodiscard]] std::size_t probe(const Coordinate* coordinates, std::uint64_t hash) const noexcept;
    void grow();

    std::size_t dimension_;
    util::SegmentedRows<Coordinate> rows_;
    std::vector<Slot> slots_;  ///< size is a power of two, at most half full
    unsigned placeShift_ = 32 - kFirstBits;
};
}  // namespace specplan::lattice
