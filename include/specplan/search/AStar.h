// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "specplan/lattice/Heuristic.h"
#include "specplan/lattice/Lattice.h"
#include "specplan/speculation/FrontierView.h"
#include "specplan/speculation/Policy.h"
#include "specplan/util/OpenList.h"
#include "specplan/validity/Broker.h"

namespace specplan::search
{
using lattice::CheckId;
using lattice::NodeId;

/// How a search ended.
enum class SearchStatus
{
    Solved,      ///< a goal was expanded
    Infeasible,  ///< OPEN is empty: no goal can be reached on this lattice
    Stopped      ///< the caller's condition; `run` may be called again and goes on
};

/// Weighted A* over a lattice whose validity is found out on the way.
///
/// Idea: the textbook's loop. States and motions are checked when an expansion first needs them; a Broker provides the
/// verdicts and may have run them ahead. Nothing here depends on when or where a check ran.
///
/// Reference: Hart, Nilsson, Raphael 1968 (A*); Pohl 1970 (weights). The numbers in the comments of the body are those
/// of docs/algorithm.md.
///
/// Holds between calls: the heuristic is constant; closed nodes are never opened again, which with a consistent
/// heuristic keeps the cost within `weight` times the optimum (Likhachev, Gordon, Thrun 2003). OPEN is totally ordered:
/// smaller f = g + weight h first, then larger g, then older entry (an improved node counts as a new entry).
///
/// Threads: one, the search thread.
class AStar : public speculation::FrontierView
{
public:
    /// \param weight at least 1. All references must outlive the search.
    AStar(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, validity::Broker& broker, double weight);

    /// Told about every expansion before it begins; may be nullptr.
    void setPolicy(speculation::Policy* policy) noexcept
    {
        policy_ = policy;
    }

    /// Told about every expansion in order; for pictures and traces. Empty for none.
    void setObserver(std::function<void(NodeId node)> observer)
    {
        observer_ = std::move(observer);
    }

    /// Adds a start; its state must be known to be valid.
    void addStart(NodeId start);

    /// Adds a goal. Its state is checked like any other.
    void addGoal(NodeId goal);

    /// Searches until a goal is expanded, OPEN is empty, or `stop` returns true; `stop` is asked once per expansion.
    /// \throws what a check threw that the search needs. The search can go on after that.
    SearchStatus run(const std::function<bool()>& stop);

    /// The expanded goal, or kNoNode.
    [[nodiscard]] NodeId reachedGoal() const noexcept
    {
        return reachedGoal_;
    }

    /// Nodes from a start to `node` along the parents.
    [[nodiscard]] std::vector<NodeId> pathTo(NodeId node) const;

    /// Cost of the best way found to a node; infinite if it was not reached.
    [[nodiscard]] double costToCome(NodeId node) const noexcept override
    {
        return node < nodes_.size() ? nodes_[node].g : kUnreached;
    }

    [[nodiscard]] NodeId parent(NodeId node) const noexcept override
    {
        return node < nodes_.size() ? nodes_[node].parent : lattice::kNoNode;
    }

    [[nodiscard]] bool isExpanded(NodeId node) const noexcept override
    {
        return node == reachedGoal_ || (node < nodes_.size() && nodes_[node].closed);
    }

    [[nodiscard]] bool isGoal(NodeId node) const noexcept override
    {
        return node < nodes_.size() && nodes_[node].goal;
    }

    [[nodiscard]] std::span<const util::OpenList::Entry> open() const noexcept override
    {
        return open_.entries();
    }

    [[nodiscard]] double weightedEstimate(NodeId node) const override
    {
        return weight_ * (node < nodes_.size() && nodes_[node].h >= 0.0 ? nodes_[node].h : heuristic_.estimate(node));
    }

    [[nodiscard]] std::uint64_t expansions() const noexcept
    {
        return expansions_;
    }

    /// Hash of the coordinates of all expanded nodes in order: equal for equal sequences.
    [[nodiscard]] std::uint64_t orderHash() const noexcept
    {
        return orderHash_;
    }

private:
    static constexpr double kUnreached = std::numeric_limits<double>::infinity();

    struct Node
    {
        double g = kUnreached;
        double h = -1.0;  ///< negative: not asked yet
        NodeId parent = lattice::kNoNode;
        bool closed = false;
        bool goal = false;
    };

    using Edge = lattice::Successors::Edge;

    [[nodiscard]] bool expand(NodeId node);
    void dropUseless(const Node& from);
    [[nodiscard]] bool dropInvalid();
    void relax(NodeId from, const Edge& edge);
    void noteExpansion(NodeId node);
    Node& touch(NodeId node);

    lattice::Lattice& lattice_;
    const lattice::Heuristic& heuristic_;
    validity::Broker& broker_;
    double weight_;
    speculation::Policy* policy_ = nullptr;
    std::function<void(NodeId)> observer_;

    std::vector<Node> nodes_;
    util::OpenList open_;
    std::uint64_t pushes_ = 0;
    std::uint64_t expansions_ = 0;
    std::uint64_t orderHash_ = 0;
    NodeId reachedGoal_ = lattice::kNoNode;
    lattice::Successors successors_;  ///< scratch of expand()
    std::vector<CheckId> checks_;     ///< scratch of dropInvalid()
};
}  // namespace specplan::search
