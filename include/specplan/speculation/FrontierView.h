// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "specplan/lattice/CheckId.h"
#include "specplan/lattice/CostAlgebra.h"
#include "specplan/lattice/NodeTable.h"
#include "specplan/util/OpenList.h"

namespace specplan::speculation
{
/// What a policy may see of the search: its OPEN list and what it knows of nodes. Implemented by the search.
///
/// Threads: search thread only.
class FrontierView
{
public:
    virtual ~FrontierView() = default;

    /// OPEN, in no particular order.
    [[nodiscard]] virtual std::span<const util::OpenList::Entry> open() const noexcept = 0;

    /// A way to a node.
    struct Way
    {
        double cost;  ///< infinite if there is none
        lattice::NodeId parent;
        std::optional<lattice::CheckId> motion;  ///< its last motion, if that still has to be asked for
    };

    /// The best way to a node unless its last motion turns out to be invalid.
    [[nodiscard]] virtual Way bestWay(lattice::NodeId node) const noexcept = 0;

    /// Whether the node was expanded.
    [[nodiscard]] virtual bool isExpanded(lattice::NodeId node) const noexcept = 0;

    [[nodiscard]] virtual bool isGoal(lattice::NodeId node) const noexcept = 0;

    /// Weight times the heuristic.
    [[nodiscard]] virtual double weightedEstimate(lattice::NodeId node) const = 0;

    /// How costs are put together.
    [[nodiscard]] virtual lattice::CostSum sum() const noexcept = 0;
};
}  // namespace specplan::speculation
