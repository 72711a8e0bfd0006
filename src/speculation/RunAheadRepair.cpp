// SPDX-License-Identifier: BSD-3-Clause
// What verdicts do to the shadow.
#include <algorithm>
#include <limits>

#include "specplan/speculation/RunAheadPolicy.h"

namespace specplan::speculation
{
using lattice::CheckId;
using lattice::NodeId;
using validity::Verdict;

void RunAheadPolicy::learned(CheckId check, bool valid)
{
    if (check.isMotion())
        predictor_.learnedMotion(valid);
    else
        predictor_.learned(check.node(), valid);
    if (!imported_)
        return;
    if (!check.isMotion() && !valid && guarded_)
        retractGuarded(check);
    const NodeId id = check.isMotion() ? lattice_.motion(check.motion()).to : check.node();
    if (id >= nodes_.size() || nodes_[id].status == Status::Unseen || frontier_.isExpanded(id))
        return;
    if (check.isMotion() && nodes_[id].parent != lattice_.motion(check.motion()).from)
        return;
    if (!valid && !check.isMotion() && nodes_[id].status == Status::Open && nodes_[id].closedAs == 0)
        forget(id);  // nothing hangs on it, and no other way leads to it
    else if (!valid)
        retract(id);
    else if (check.isMotion())
        confirmMotion(id);
    else
        confirmState(id);
}

void RunAheadPolicy::confirmState(NodeId id)
{
    const double known = static_cast<double>(nodes_[id].ofState);
    nodes_[id].ofState = 1.0F;
    raise(id, known, delayFor(known));
    if (nodes_[id].guarded)
        emitGuardsOf(id);
    if (nodes_[id].status == Status::Closed)
        emitMotionTo(id, id);
}

void RunAheadPolicy::confirmMotion(NodeId id)
{
    const double known = static_cast<double>(nodes_[id].ofMotion);
    nodes_[id].ofMotion = 1.0F;
    raise(id, known, delayForMotion(known));
}

/// The end is valid: now the states beside the motion to it are worth a check.
void RunAheadPolicy::emitGuardsOf(NodeId id)
{
    const NodeId parent = nodes_[id].parent;
    if (parent == lattice::kNoNode)
        return;
    lattice_.successors(parent, around_);
    for (const lattice::Successors::Edge& edge : around_.edges)
        if (edge.node == id)
            for (const CheckId guard : around_.guardsOf(edge))
                if (broker_.verdict(guard) == Verdict::Unknown)
                    emit(guard, parent);
}

/// A probability has become certainty: all that hangs on it is more likely by this factor, and comes sooner.
void RunAheadPolicy::raise(NodeId root, double known, double delay)
{
    if (known == 1.0)
        return;
    subtree_.assign(1, root);
    for (std::size_t i = 0; i < subtree_.size(); ++i)
    {
        const NodeId id = subtree_[i];
        nodes_[id].probability = std::min(nodes_[id].probability / known, 1.0);
        nodes_[id].delay = std::max(nodes_[id].delay - delay, 0.0);
        if (nodes_[id].status == Status::Open)
        {
            push(id);
            continue;
        }
        lattice_.neighbours(id, neighbours_);
        for (const NodeId neighbour : neighbours_)
            if (isChild(neighbour, id))
                subtree_.push_back(neighbour);
    }
}

void RunAheadPolicy::forget(NodeId id)
{
    Node& node = nodes_[id];
    if (node.status == Status::Open)
        open_.erase(id);
    node.status = Status::Unseen;
    node.g = std::numeric_limits<double>::infinity();
    node.closedAs = 0;
    node.parent = lattice::kNoNode;
}

/// Takes back everything that the shadow reached through the root, and joins it again to what borders on it.
void RunAheadPolicy::retract(NodeId root)
{
    subtree_.assign(1, root);
    rim_.clear();
    for (std::size_t i = 0; i < subtree_.size(); ++i)
    {
        const NodeId id = subtree_[i];
        lattice_.neighbours(id, neighbours_);
        for (const NodeId neighbour : neighbours_)
        {
            if (isChild(neighbour, id))
                subtree_.push_back(neighbour);
            else if (isClosed(neighbour))
                rim_.push_back(neighbour);
        }
        forget(id);
    }
    std::sort(rim_.begin(), rim_.end());
    rim_.erase(std::unique(rim_.begin(), rim_.end()), rim_.end());
    for (const NodeId from : rim_)
        if (isClosed(from))
            relaxFrom(from);
}

/// Takes back the nodes that were reached past a state that is invalid.
void RunAheadPolicy::retractGuarded(CheckId guard)
{
    lattice_.successors(guard.node(), successors_);
    std::vector<NodeId> ends;
    for (const lattice::Successors::Edge& edge : successors_.edges)
        if (edge.node < nodes_.size() && nodes_[edge.node].status != Status::Unseen &&
            !frontier_.isExpanded(edge.node) && isGuardedBy(edge.node, guard))
            ends.push_back(edge.node);
    for (const NodeId end : ends)
        if (nodes_[end].status != Status::Unseen)
            retract(end);
}

bool RunAheadPolicy::isGuardedBy(NodeId end, CheckId guard)
{
    const NodeId parent = nodes_[end].parent;
    if (parent == lattice::kNoNode)
        return false;
    lattice_.successors(parent, around_);
    return std::ranges::any_of(around_.edges,
                               [&](const lattice::Successors::Edge& edge)
                               {
                                   const auto inner = around_.innerOf(edge);
                                   return edge.node == end &&
                                          std::find(inner.begin(), inner.end(), guard) != inner.end();
                               });
}

bool RunAheadPolicy::isClosed(NodeId node) const
{
    return node < nodes_.size() && nodes_[node].status == Status::Closed;
}

/// Whether the shadow, not the search itself, reached `node` from `parent`.
bool RunAheadPolicy::isChild(NodeId node, NodeId parent) const
{
    return node < nodes_.size() && nodes_[node].parent == parent && nodes_[node].status != Status::Unseen &&
           !frontier_.isExpanded(node);
}
}  // namespace specplan::speculation
