// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/AStar.h"

#include <algorithm>

#include "specplan/util/Hash.h"

namespace specplan::search
{
using validity::Verdict;

AStar::AStar(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, validity::Broker& broker, double weight)
    : lattice_(lattice), heuristic_(heuristic), broker_(broker), weight_(weight)
{
}

void AStar::addStart(NodeId start)
{
    Node& node = touch(start);
    if (node.g <= 0.0)
        return;
    node.g = 0.0;
    node.parent = lattice::kNoNode;
    open_.push(start, {weight_ * node.h, 0.0, pushes_++});
}

void AStar::addGoal(NodeId goal)
{
    touch(goal).goal = true;
}

SearchStatus AStar::run(const std::function<bool()>& stop)
{
    if (reachedGoal_ != lattice::kNoNode)
        return SearchStatus::Solved;
    while (!open_.empty())  // 1
    {
        if (stop())
            return SearchStatus::Stopped;
        const NodeId node = open_.top().item;  // 2: best node of OPEN
        if (nodes_[node].goal)                 // 3: a goal is expanded: done
        {
            noteExpansion(node);
            open_.pop();
            reachedGoal_ = node;
            return SearchStatus::Solved;
        }
        if (!expand(node))
            return SearchStatus::Stopped;
    }
    return SearchStatus::Infeasible;
}

bool AStar::expand(NodeId node)
{
    if (policy_ != nullptr)
        policy_->expanding(node, nodes_[node].parent);
    lattice_.successors(node, successors_);
    dropUseless(nodes_[node]);  // 4: closed, or no better than a way already found
    if (!dropInvalid())         // 5: states and motions that collide
        return false;           // interrupted: the node stays on OPEN as it was
    open_.pop();
    nodes_[node].closed = true;
    noteExpansion(node);
    for (const Edge& edge : successors_.edges)  // 6
        relax(node, edge);
    return true;
}

void AStar::dropUseless(const Node& from)
{
    const double g = from.g;
    std::erase_if(successors_.edges,
                  [this, g](const Edge& edge)
                  {
                      const Node& end = touch(edge.node);
                      return end.closed || !(g + edge.cost < end.g);
                  });
}

bool AStar::dropInvalid()
{
    checks_.clear();
    for (const Edge& edge : successors_.edges)
        checks_.push_back(CheckId::ofState(edge.node));
    if (!broker_.demand(checks_))
        return false;
    std::erase_if(successors_.edges, [this](const Edge& edge)
                  { return broker_.verdict(CheckId::ofState(edge.node)) == Verdict::Invalid; });
    if (successors_.inner.empty())
        return true;

    checks_.clear();
    for (const Edge& edge : successors_.edges)
        std::ranges::copy(successors_.innerOf(edge), std::back_inserter(checks_));
    if (!broker_.demand(checks_))
        return false;
    std::erase_if(successors_.edges,
                  [this](const Edge& edge)
                  {
                      return std::ranges::any_of(successors_.innerOf(edge), [this](CheckId check)
                                                 { return broker_.verdict(check) == Verdict::Invalid; });
                  });
    return true;
}

void AStar::relax(NodeId from, const Edge& edge)
{
    Node& end = nodes_[edge.node];
    const double g = nodes_[from].g + edge.cost;
    if (!(g < end.g))
        return;  // a second motion of this expansion to the same node
    end.g = g;
    end.parent = from;
    open_.push(edge.node, {end.g + weight_ * end.h, end.g, pushes_++});
}

void AStar::noteExpansion(NodeId node)
{
    ++expansions_;
    orderHash_ = util::mix(orderHash_, util::hashCoordinates(lattice_.coordinates(node)));
    if (observer_)
        observer_(node);
}

AStar::Node& AStar::touch(NodeId node)
{
    if (node >= nodes_.size())
        nodes_.resize(std::max<std::size_t>(lattice_.size(), nodes_.size() * 2));
    if (nodes_[node].h < 0.0)
        nodes_[node].h = heuristic_.estimate(node);
    return nodes_[node];
}

std::vector<NodeId> AStar::pathTo(NodeId node) const
{
    std::vector<NodeId> path;
    for (; node != lattice::kNoNode; node = parent(node))
        path.push_back(node);
    std::ranges::reverse(path);
    return path;
}
}  // namespace specplan::search
