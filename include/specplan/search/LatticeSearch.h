// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "specplan/lattice/NodeTable.h"

namespace specplan::search
{
using lattice::NodeId;

/// How a search ended.
enum class SearchStatus
{
    Solved,      ///< a path to a goal is known
    Infeasible,  ///< no goal can be reached on this lattice
    Stopped      ///< the caller's condition; `run` may be called again and goes on
};

/// What all searches have in common once starts and goals are set.
///
/// Threads: one, the search thread.
class LatticeSearch
{
public:
    virtual ~LatticeSearch() = default;

    /// Searches until a path is found, there is none, or `stop` returns true.
    /// \throws what a check threw that the search needs. The search can go on after that.
    virtual SearchStatus run(const std::function<bool()>& stop) = 0;

    /// The goal that was reached, or kNoNode.
    [[nodiscard]] virtual NodeId reachedGoal() const noexcept = 0;

    /// Nodes from a start to `node` along the parents.
    [[nodiscard]] virtual std::vector<NodeId> pathTo(NodeId node) const = 0;

    /// Cost of the best way to a node that is known to be valid; infinite if there is none.
    [[nodiscard]] virtual double costToCome(NodeId node) const noexcept = 0;

    /// Node before `node` on that way, or kNoNode.
    [[nodiscard]] virtual NodeId parent(NodeId node) const noexcept = 0;

    /// Whether the search knows any way to the node, also one that may still turn out to be invalid.
    [[nodiscard]] virtual bool isReached(NodeId node) const noexcept = 0;

    /// Whether the search has been at the node: has expanded it, or asked for its state if it expands on trust.
    [[nodiscard]] virtual bool isExpanded(NodeId node) const noexcept = 0;

    /// Number of steps taken: of expansions, or of checks decided on. The same whoever runs the checks.
    [[nodiscard]] virtual std::uint64_t steps() const noexcept = 0;

    /// Hash of the sequence of steps: equal for equal sequences.
    [[nodiscard]] virtual std::uint64_t orderHash() const noexcept = 0;
};
}  // namespace specplan::search
