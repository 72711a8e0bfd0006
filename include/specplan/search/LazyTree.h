// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "specplan/lattice/Heuristic.h"
#include "specplan/lattice/Lattice.h"
#include "specplan/util/GrowingArray.h"
#include "specplan/util/OpenList.h"
#include "specplan/util/PagedTable.h"
#include "specplan/util/RowPool.h"
#include "specplan/util/SegmentedRows.h"
#include "specplan/validity/Verdict.h"

namespace specplan::search
{
using lattice::CheckId;
using lattice::NodeId;

/// The shortest path from the starts to the nearest goal while unknown states and motions count as valid, kept up to
/// date as verdicts come in.
///
/// Idea: Lifelong Planning A* (Koenig, Likhachev, Furcy 2004). A node is consistent if its g is what its predecessors
/// promise, its rhs; a verdict makes some nodes inconsistent, and only these and what depends on them is looked at
/// again. What a verdict closes is found at once, before anything else is repaired (Ramalingam, Reps 1996): so no node
/// is repaired twice for one verdict.
///
/// Every change can be written to a journal and taken back exactly, so that a search may try out verdicts.
///
/// Costs are rounded to multiples of a power of two small enough (2^-36 of a step) that nobody notices, and large
/// enough that sums of them are exact: equal paths have equal costs, in whatever order they were summed. What follows
/// from a series of verdicts depends on the problem alone, not on the numbers that nodes happen to have: ties are
/// broken by coordinates.
///
/// Threads: one, the search thread.
class LazyTree
{
public:
    using EdgeId = std::uint32_t;
    using OpenEntry = util::OpenList::Entry;
    static constexpr double kUnreached = std::numeric_limits<double>::infinity();

    /// A node's values before a change.
    struct Change
    {
        double g;
        double rhs;
        NodeId node;
        EdgeId via;
    };
    using Journal = std::vector<Change>;

    /// The references must outlive the tree. The path is at most `weight` times as long as the shortest one; with a
    /// weight above 1 no node is given a better way once others are built on it, unless it loses its own.
    LazyTree(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, double weight = 1.0);

    void addStart(NodeId start);
    void addGoal(NodeId goal);

    /// Whether a state is to be checked before ways to others are built on it. Asked for unknown states; empty for
    /// never.
    void setDoubt(std::function<bool(NodeId)> doubt)
    {
        doubt_ = std::move(doubt);
    }

    enum class Repair
    {
        Done,        ///< the shortest path is known
        Unfinished,  ///< `budget` nodes have been expanded
        Doubtful     ///< the first of doubtful() has to be checked before
    };

    /// Goes on with the repair.
    [[nodiscard]] Repair repair(std::size_t budget);

    /// After Repair::Doubtful: the node whose state the repair waits for, and those for which it may wait soon, in that
    /// order. \param count number of entries of OPEN to look at.
    void doubtful(std::size_t count, std::vector<NodeId>& out);

    /// All entries of OPEN, only roughly in order.
    [[nodiscard]] std::span<const OpenEntry> open() const noexcept
    {
        return open_.entries();
    }

    /// Whether the node's state has to be checked when its turn comes.
    [[nodiscard]] bool isDoubtful(const OpenEntry& entry) const;

    /// Whether ways to other nodes may lead through this one.
    [[nodiscard]] bool isPassed(NodeId node) const noexcept
    {
        return node < nodes_.size() && nodes_[node].g < kUnreached;
    }

    /// Whether a passed node is nearer to the start than another one. Never true for both orders.
    [[nodiscard]] bool comesBefore(NodeId node, NodeId other) const;

    /// Whether the way to a passed node leads through one of these, which come before it, the nearest first.
    [[nodiscard]] bool comesThrough(NodeId node, std::span<const NodeId> others) const;

    /// After repair(): the motions of the shortest path, last one first.
    /// \return false if a motion turned out to be closed by what lies beside it: repair again.
    [[nodiscard]] bool findPath(std::vector<EdgeId>& path);

    /// After repair(): the goal of that path, or kNoNode if no goal can be reached.
    [[nodiscard]] NodeId nearestGoal();

    /// Applies a verdict.
    void enter(CheckId check, bool valid);

    /// What has been entered for a check: Unknown, Valid or Invalid. Starts are valid.
    [[nodiscard]] validity::Verdict verdict(CheckId check) const noexcept;

    /// Writes all changes from now on to the journal, which must outlive that; nullptr for none.
    void record(Journal* journal);

    /// Takes back a verdict and all changes in its journal. Journals have to be taken back in reverse order.
    void undo(CheckId check, const Journal& journal);

    [[nodiscard]] NodeId from(EdgeId edge) const noexcept
    {
        return edges_[edge].from;
    }

    [[nodiscard]] NodeId to(EdgeId edge) const noexcept
    {
        return edges_[edge].to;
    }

    /// Appends the checks of a motion besides that of its end.
    void addInner(EdgeId edge, std::vector<CheckId>& out) const;

    /// Number of a motion among those out of its node.
    [[nodiscard]] std::size_t indexOf(EdgeId edge) const noexcept
    {
        return edge - nodes_[edges_[edge].from].firstOut;
    }

    [[nodiscard]] bool isGoal(NodeId node) const noexcept
    {
        return node < nodes_.size() && nodes_[node].goal;
    }

    /// Nodes expanded, those included that verdicts tried out made necessary.
    [[nodiscard]] std::uint64_t expansions() const noexcept
    {
        return expansions_;
    }

private:
    static constexpr EdgeId kNoEdge = std::numeric_limits<EdgeId>::max();
    static constexpr std::uint32_t kOnlyMotion = 1U << 31;

    /// A known motion into a node, with what is looked at of it.
    struct Into
    {
        double cost;
        NodeId from;
        EdgeId edge;
    };

    /// What is looked at of a node when a neighbour of it changes: half a cache line.
    struct Node
    {
        double g = kUnreached;
        double rhs = kUnreached;
        EdgeId via = kNoEdge;       ///< the motion that rhs comes from
        EdgeId firstOut = kNoEdge;  ///< motions out of the node, once they were asked for
        std::uint16_t out = 0;      ///< number of motions out of the node
        validity::Verdict verdict = validity::Verdict::Unknown;
        bool start = false;
        bool goal = false;
        bool tied = false;  ///< whether another motion may lead into the node at the same cost
    };

    /// What else there is of a node.
    struct Details
    {
        double h = -1.0;                ///< weighted; negative: not asked yet
        std::uint64_t rank = 0;         ///< breaks ties on OPEN; from the coordinates
        std::uint64_t recorded = 0;     ///< journal that has this node's values
        util::RowPool<Into>::Row into;  ///< known motions into the node
    };

    struct Edge
    {
        double cost;  ///< rounded
        NodeId from;
        NodeId to;
        std::uint32_t inner;  ///< its checks: 0 for none, a motion's number with kOnlyMotion, or the first in inner_
    };

    [[nodiscard]] bool isDone();
    void expand(NodeId node);
    void lose(NodeId node);
    void forsake(NodeId node);
    void look(NodeId node);
    void set(NodeId node, double g, double rhs, EdgeId via);
    void place(NodeId node);
    void connect(NodeId node);
    void chooseUnit(NodeId start);
    [[nodiscard]] double costOf(const Edge& edge) const noexcept;
    [[nodiscard]] bool isClosed(const Edge& edge) const noexcept;
    [[nodiscard]] std::uint32_t keepInner(std::span<const CheckId> inner);
    void fetch(std::size_t lost) const noexcept;
    [[nodiscard]] double rounded(double cost) const noexcept;
    [[nodiscard]] EdgeId bestInto(NodeId node) const;
    [[nodiscard]] bool isPreferred(EdgeId edge, EdgeId other) const;
    Node& touch(NodeId node);

    lattice::Lattice& lattice_;
    const lattice::Heuristic& heuristic_;
    double weight_;
    double unit_ = 0.0;  ///< costs are multiples of it; 0 before the first start
    util::GrowingArray<Node> nodes_;
    util::GrowingArray<Details> details_;  ///< parallel to nodes_
    util::SegmentedRows<Edge> edges_;
    util::RowPool<Into> into_;
    std::vector<CheckId> inner_;              ///< checks of motions that have several; the first is not used
    std::vector<std::uint32_t> innerCounts_;  ///< parallel to inner_: number of checks from there on in their motion
    util::PagedTable<validity::Verdict> motions_;
    std::vector<NodeId> goals_;
    NodeId nearestGoal_ = lattice::kNoNode;
    bool goalsChanged_ = true;
    util::OpenList open_;
    std::function<bool(NodeId)> doubt_;
    Journal* journal_ = nullptr;
    std::uint64_t journals_ = 0;
    std::uint64_t expansions_ = 0;
    std::vector<NodeId> forsaken_;    ///< scratch of lose(): nodes whose ways on have to be given up
    std::vector<NodeId> lost_;        ///< nodes that may have lost their way and not looked for another one
    lattice::Successors successors_;  ///< scratch of connect()
};
}  // namespace specplan::search
