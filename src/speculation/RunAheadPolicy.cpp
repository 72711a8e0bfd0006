// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/RunAheadPolicy.h"

#include <algorithm>
#include <cmath>

namespace specplan::speculation
{
using lattice::CheckId;
using lattice::NodeId;
using validity::Verdict;

namespace
{
constexpr double kUnreached = std::numeric_limits<double>::infinity();
}  // namespace

RunAheadPolicy::RunAheadPolicy(lattice::Lattice& lattice, const validity::Broker& broker, const FrontierView& frontier,
                               Predictor& predictor)
    : lattice_(lattice), broker_(broker), frontier_(frontier), predictor_(predictor)
{
}

void RunAheadPolicy::expanding(NodeId node, NodeId)
{
    if (imported_)
        behind_.push_back(node);
}

void RunAheadPolicy::propose(std::size_t count, std::vector<CheckId>& out)
{
    synchronise();
    const std::size_t full = out.size() + count;
    while (out.size() < full)
    {
        if (pending_.empty())
        {
            if (!advance())
                return;
            continue;
        }
        const Pending next = pending_.top();
        pending_.pop();
        // Dropped if it has lost its point: known or running by now, or the shadow no longer gets there.
        if (broker_.verdict(next.check) == Verdict::Unknown && isClosed(next.from) &&
            std::ranges::find(out, next.check) == out.end())
            out.push_back(next.check);
    }
}

void RunAheadPolicy::synchronise()
{
    if (!imported_)
        importFrontier();
    for (const NodeId node : behind_)
        follow(node);
    behind_.clear();
}

void RunAheadPolicy::importFrontier()
{
    imported_ = true;
    for (const util::OpenList::Entry& entry : frontier_.open())
    {
        Node& node = touch(entry.item);
        node.g = frontier_.costToCome(entry.item);
        node.parent = frontier_.parent(entry.item);
        node.status = Status::Open;
        open_.push(entry.item, {entry.key.f, entry.key.g, pushes_++});
    }
}

void RunAheadPolicy::follow(NodeId id)
{
    Node& node = touch(id);
    const double g = frontier_.costToCome(id);
    if (node.status == Status::Closed && node.g <= g)
        return;
    if (node.status == Status::Open)
        open_.erase(id);
    node.g = g;
    node.parent = frontier_.parent(id);
    node.status = Status::Closed;
    node.closedAs = ++expansions_;
    relaxFrom(id);
}

bool RunAheadPolicy::advance()
{
    if (open_.empty() || frontier_.isGoal(open_.top().item))
        return false;
    const NodeId id = open_.pop().item;
    nodes_[id].status = Status::Closed;
    nodes_[id].closedAs = ++expansions_;
    relaxFrom(id);
    return true;
}

void RunAheadPolicy::relaxFrom(NodeId node)
{
    lattice_.successors(node, successors_);
    for (const lattice::Successors::Edge& edge : successors_.edges)
        relax(node, edge);
}

void RunAheadPolicy::relax(NodeId from, const lattice::Successors::Edge& edge)
{
    if (frontier_.isExpanded(edge.node))
        return;
    Node& end = touch(edge.node);
    const double g = nodes_[from].g + edge.cost;
    if (end.status == Status::Closed || !(g < end.g))
        return;
    const CheckId state = CheckId::ofState(edge.node);
    const Verdict verdict = broker_.verdict(state);
    if (verdict == Verdict::Invalid)
        return;
    if (verdict == Verdict::Unknown)
        emit(state, from);
    for (const CheckId inner : successors_.innerOf(edge))
    {
        const Verdict known = broker_.verdict(inner);
        if (known == Verdict::Invalid)
            return;
        if (known == Verdict::Unknown && verdict == Verdict::Valid)
            emit(inner, from);
    }
    if (verdict != Verdict::Valid && !predictor_.isLikelyValid(from, edge.node))
    {
        end.heldBack = true;
        return;
    }
    end.g = g;
    end.parent = from;
    end.status = Status::Open;
    open_.push(edge.node, {g + end.h, g, pushes_++});
}

void RunAheadPolicy::learned(CheckId check, bool valid)
{
    if (!check.isMotion())
        predictor_.learned(check.node(), valid);
    if (!imported_)
        return;
    const NodeId id = check.isMotion() ? lattice_.motion(check.motion()).to : check.node();
    if (id >= nodes_.size())
        return;
    Node& node = nodes_[id];
    if (!valid)
    {
        const bool used = !check.isMotion() || node.parent == lattice_.motion(check.motion()).from;
        if (node.status != Status::Unseen && used && !frontier_.isExpanded(id))
            retract(id);
        return;
    }
    if (check.isMotion())
        return;
    if (node.heldBack && node.status == Status::Unseen)
    {
        node.heldBack = false;
        lattice_.successors(id, around_);
        rim_.clear();
        for (const lattice::Successors::Edge& edge : around_.edges)
            if (isClosed(edge.node))
                rim_.push_back(edge.node);
        for (const NodeId from : rim_)
            relaxFrom(from);
    }
    else if (node.status != Status::Unseen && node.parent != lattice::kNoNode)
    {
        // The state is valid: now the inside of the motion to it is worth a check.
        lattice_.successors(node.parent, around_);
        if (around_.inner.empty())
            return;
        for (const lattice::Successors::Edge& edge : around_.edges)
            if (edge.node == id)
                for (const CheckId inner : around_.innerOf(edge))
                    if (broker_.verdict(inner) == Verdict::Unknown)
                        emit(inner, node.parent);
    }
}

void RunAheadPolicy::retract(NodeId root)
{
    // Everything that the shadow reached through the root, and what borders on it.
    subtree_.assign(1, root);
    rim_.clear();
    for (std::size_t i = 0; i < subtree_.size(); ++i)
    {
        const NodeId id = subtree_[i];
        lattice_.successors(id, around_);
        for (const lattice::Successors::Edge& edge : around_.edges)
        {
            if (edge.node < nodes_.size() && nodes_[edge.node].parent == id &&
                nodes_[edge.node].status != Status::Unseen && !frontier_.isExpanded(edge.node))
                subtree_.push_back(edge.node);
            else if (isClosed(edge.node))
                rim_.push_back(edge.node);
        }
        Node& node = nodes_[id];
        if (node.status == Status::Open)
            open_.erase(id);
        node.status = Status::Unseen;
        node.g = kUnreached;
        node.parent = lattice::kNoNode;
    }
    std::ranges::sort(rim_);
    rim_.erase(std::unique(rim_.begin(), rim_.end()), rim_.end());
    for (const NodeId from : rim_)
        if (isClosed(from))
            relaxFrom(from);
}

void RunAheadPolicy::emit(CheckId check, NodeId from)
{
    pending_.push({nodes_[from].closedAs, pushes_++, check, from});
}

bool RunAheadPolicy::isClosed(NodeId node) const
{
    return node < nodes_.size() && nodes_[node].status == Status::Closed;
}

RunAheadPolicy::Node& RunAheadPolicy::touch(NodeId node)
{
    if (node >= nodes_.size())
        nodes_.resize(std::max<std::size_t>(lattice_.size(), nodes_.size() * 2));
    if (nodes_[node].h < 0.0)
    {
        nodes_[node].h = frontier_.weightedEstimate(node);
        if (frontier_.isExpanded(node))
        {
            nodes_[node].status = Status::Closed;
            nodes_[node].g = frontier_.costToCome(node);
            nodes_[node].parent = frontier_.parent(node);
        }
    }
    return nodes_[node];
}
}  // namespace specplan::speculation
