// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "specplan/lattice/NodeTable.h"
#include "specplan/util/SegmentedRows.h"

namespace specplan::lattice
{
/// A row of nodes for some of the nodes: what would take many look-ups in a NodeTable to find again.
///
/// Threads: one owner.
class NodeRows
{
public:
    /// \param width nodes in a row; may be 0.
    explicit NodeRows(std::size_t width) : width_(width), rows_(std::max<std::size_t>(width, 1))
    {
    }

    /// The row of a node, or nullptr if it has none.
    [[nodiscard]] NodeId* find(NodeId node) noexcept
    {
        return has(node) ? rows_.row(numbers_[node]) : nullptr;
    }

    [[nodiscard]] bool has(NodeId node) const noexcept
    {
        return node < numbers_.size() && numbers_[node] != kNone;
    }

    /// Makes a row for a node that has none, full of kNoNode.
    NodeId* make(NodeId node)
    {
        if (node >= numbers_.size())
            numbers_.resize(std::max<std::size_t>(node + std::size_t{1}, numbers_.size() * 2), kNone);
        numbers_[node] = static_cast<std::uint32_t>(rows_.size());
        NodeId* row = rows_.append();
        std::fill_n(row, width_, kNoNode);
        return row;
    }

    [[nodiscard]] std::size_t width() const noexcept
    {
        return width_;
    }

private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    std::size_t width_;
    std::vector<std::uint32_t> numbers_;  ///< of the rows, by node
    util::SegmentedRows<NodeId> rows_;
};
}  // namespace specplan::lattice
