// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

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

    /// Cost of the best way found to a node; infinite if it was not reached.
    [[nodiscard]] virtual double costToCome(lattice::NodeId node) const noexcept = 0;

    [[nodiscard]] virtual lattice::NodeId parent(lattice::NodeId node) const noexcept = 0;

    /// Whether the node was expanded.
    [[nodiscard]] virtual bool isExpanded(lattice::NodeId node) const noexcept = 0;

    [[nodiscard]] virtual bool isGoal(lattice::NodeId node) const noexcept = 0;

    /// Weight times the heuristic.
    [[nodiscard]] virtual double weightedEstimate(lattice::NodeId node) const = 0;

    /// How costs are put together.
    [[nodiscard]] virtual lattice::CostSum sum() const noexcept = 0;
};
}  // namespace specplan::speculation
