// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "specplan/lattice/CostAlgebra.h"
#include "specplan/lattice/Heuristic.h"
#include "specplan/lattice/Lattice.h"
#include "specplan/search/LatticeSearch.h"
#include "specplan/speculation/FrontierView.h"
#include "specplan/speculation/Policy.h"
#include "specplan/util/GrowingArray.h"
#include "specplan/util/OpenList.h"
#include "specplan/validity/Broker.h"

namespace specplan::search
{
using lattice::CheckId;

/// Weighted A* over a lattice whose validity is found out on the way.
///
/// Idea: the textbook's loop. States are checked when an expansion first meets them, and the inside of a motion when
/// its end comes to be expanded: most motions that A* meets are never the best way to their end. A Broker provides the
/// verdicts and may have run them ahead. Nothing here depends on when or where a check ran, and no expansion on when
/// motions are checked.
///
/// Reference: Hart, Nilsson, Raphael 1968 (A*); Pohl 1970 (weights). The numbers in the comments of the body are those
/// of docs/algorithm.md.
///
/// Holds between calls: the heuristic is constant, or `heuristicChanged` was called. Closed nodes are never opened
/// again, which with a consistent heuristic keeps the cost within `weight` times the optimum (Likhachev, Gordon, Thrun
/// 2003); `setReopening` opens them again, for heuristics that are admissible only. OPEN is totally ordered: smaller f
/// = g + weight h first, then larger g, then older entry (an improved node counts as a new entry). Costs are put
/// together by a CostAlgebra where they do not add up; the weight is 1 then.
///
/// Threads: one, the search thread.
class AStar : public LatticeSearch, public speculation::FrontierView
{
public:
    /// \param weight at least 1. \param sum how costs are put together. All references must outlive the search.
    AStar(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, validity::Broker& broker, double weight,
          lattice::CostSum sum = {});

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

    /// Opens closed nodes again that are reached better later on: for heuristics that are not known to be consistent.
    void setReopening(bool reopening) noexcept
    {
        reopening_ = reopening;
    }

    /// Asked for each node that is taken off OPEN; the node is a goal if it returns true. Empty for none.
    void setGoalTest(std::function<bool(NodeId node)> isGoal)
    {
        goalTest_ = std::move(isGoal);
    }

    /// Adds a start with a cost of its own; its state must be known to be valid.
    void addStart(NodeId start, double cost);

    void addStart(NodeId start)
    {
        addStart(start, sum_.identity());
    }

    /// Adds a goal, also during a search: then `heuristicChanged` has to follow. Its state is checked like any other.
    void addGoal(NodeId goal);

    /// A motion out of this node has come up during the search: a closed node is opened again. `heuristicChanged` has
    /// to follow.
    void motionAdded(NodeId from);

    /// Goals have come up, so estimates have fallen: asks for all of them again.
    void heuristicChanged();

    /// Searches until a goal is expanded, OPEN is empty, or `stop` returns true; `stop` is asked before each expansion
    /// and each motion's check.
    /// \throws what a check threw that the search needs. The search can go on after that.
    SearchStatus run(const std::function<bool()>& stop) override;

    /// The expanded goal, or kNoNode.
    [[nodiscard]] NodeId reachedGoal() const noexcept override
    {
        return reachedGoal_;
    }

    /// Nodes from a start to `node` along the parents.
    [[nodiscard]] std::vector<NodeId> pathTo(NodeId node) const override;

    /// Cost of the best way to a node that is known to be valid; infinite if there is none.
    [[nodiscard]] double costToCome(NodeId node) const noexcept override
    {
        return node < nodes_.size() ? nodes_[node].g : kUnreached;
    }

    [[nodiscard]] bool isReached(NodeId node) const noexcept override
    {
        return node < nodes_.size() && (nodes_[node].g != kUnreached || nodes_[node].ways != kNoWay);
    }

    [[nodiscard]] FrontierView::Way bestWay(NodeId node) const noexcept override;

    /// Node before `node` on that way, or kNoNode.
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
        return weight_ * (node < nodes_.size() && isAsked(nodes_[node].h) ? nodes_[node].h : heuristic_.estimate(node));
    }

    [[nodiscard]] lattice::CostSum sum() const noexcept override
    {
        return sum_;
    }

    [[nodiscard]] std::uint64_t expansions() const noexcept
    {
        return expansions_;
    }

    [[nodiscard]] std::uint64_t steps() const noexcept override
    {
        return expansions_;
    }

    /// Hash of the coordinates of all expanded nodes in order: equal for equal sequences.
    [[nodiscard]] std::uint64_t orderHash() const noexcept override
    {
        return orderHash_;
    }

private:
    static constexpr double kUnreached = std::numeric_limits<double>::infinity();
    static constexpr double kNotAsked = std::numeric_limits<double>::quiet_NaN();

    [[nodiscard]] static bool isAsked(double h) noexcept
    {
        return !std::isnan(h);
    }

    static constexpr std::uint32_t kNoWay = std::numeric_limits<std::uint32_t>::max();

    struct Node
    {
        double g = kUnreached;  ///< of the best way known to be valid
        double h = kNotAsked;
        std::uint64_t age = 0;             ///< when that way was found
        NodeId parent = lattice::kNoNode;  ///< on that way
        std::uint32_t ways = kNoWay;       ///< the best of the better ways whose last motion is open
        bool closed = false;
        bool goal = false;
    };

    /// A way to a node whose last motion has not been asked for. A node's ways are a list, the best one first,
    /// the others in no order: most are never needed.
    struct TentativeWay
    {
        double g;
        double parentG;
        std::uint64_t age;
        NodeId parent;
        CheckId motion;
        std::uint32_t next;  ///< or kNoWay
    };

    using Edge = lattice::Successors::Edge;

    [[nodiscard]] bool expand(NodeId node);
    [[nodiscard]] bool improves(double g, const Node& end) const noexcept;
    void dropUseless(const Node& from);
    [[nodiscard]] bool dropInvalid();
    void relax(NodeId from, const Edge& edge);
    [[nodiscard]] bool confirmWay(NodeId node);
    void settle(NodeId node, double g, std::uint64_t age, NodeId parent);
    void addWay(NodeId node, const TentativeWay& way);
    void putBestFirst(std::uint32_t& first);
    void dropWay(std::uint32_t& link);
    void place(NodeId node);
    [[nodiscard]] util::OpenKey earliestKey(const TentativeWay& way, double h) const;
    void noteExpansion(NodeId node);
    [[nodiscard]] bool isGoalNow(NodeId node) const;
    Node& touch(NodeId node);

    lattice::Lattice& lattice_;
    const lattice::Heuristic& heuristic_;
    validity::Broker& broker_;
    double weight_;
    lattice::CostSum sum_;
    bool reopening_ = false;
    speculation::Policy* policy_ = nullptr;
    std::function<void(NodeId)> observer_;
    std::function<bool(NodeId)> goalTest_;

    util::GrowingArray<Node> nodes_;
    std::vector<TentativeWay> ways_;
    std::uint32_t unusedWays_ = kNoWay;  ///< list of those dropped
    util::OpenList open_;
    std::uint64_t pushes_ = 0;
    std::uint64_t expansions_ = 0;
    std::uint64_t orderHash_ = 0;
    NodeId reachedGoal_ = lattice::kNoNode;
    lattice::Successors successors_;  ///< scratch of expand()
    std::vector<CheckId> checks_;     ///< scratch of dropInvalid() and confirmWay()
};
}  // namespace specplan::search
