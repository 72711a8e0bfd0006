// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/AStar.h"

#include <algorithm>

#include "specplan/util/Hash.h"

namespace specplan::search
{
using validity::Verdict;

namespace
{
/// A closed node is opened again only for more than rounding: a better sum of the same costs in another order.
constexpr double kRounding = 1e-12;
}  // namespace

AStar::AStar(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, validity::Broker& broker, double weight,
             lattice::CostSum sum)
    : lattice_(lattice), heuristic_(heuristic), broker_(broker), weight_(sum.adds() ? weight : 1.0), sum_(sum)
{
}

void AStar::addStart(NodeId start, double cost)
{
    Node& node = touch(start);
    if (!(cost < node.g))
        return;
    node.g = cost;
    node.parent = lattice::kNoNode;
    open(start);
}

void AStar::addGoal(NodeId goal)
{
    Node& node = touch(goal);
    node.goal = true;
    if (node.closed)
        open(goal);  // the search has been here, not knowing where it was
}

void AStar::heuristicChanged()
{
    for (Node& node : nodes_)
        node.h = kNotAsked;
    std::vector<util::OpenList::Entry> entries(open_.entries().begin(), open_.entries().end());
    for (util::OpenList::Entry& entry : entries)
    {
        entry.key.f = sum_(entry.key.g, weight_ * touch(entry.item).h);
        open_.push(entry.item, entry.key);
    }
    if (policy_ != nullptr)
        policy_->missed();
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
        if (isGoalNow(node))                   // 3: a goal is expanded: done
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
    learnCosts();
    open_.pop();
    nodes_[node].closed = true;
    noteExpansion(node);
    for (const Edge& edge : successors_.edges)  // 6
        relax(node, edge);
    return true;
}

bool AStar::isGoalNow(NodeId node) const
{
    return nodes_[node].goal || (goalTest_ && goalTest_(node));
}

bool AStar::improves(double g, const Node& end) const noexcept
{
    if (!end.closed)
        return g < end.g;
    return reopening_ && g < end.g - kRounding * std::abs(end.g);
}

void AStar::dropUseless(const Node& from)
{
    const double g = from.g;
    std::erase_if(successors_.edges,
                  [this, g](const Edge& edge) { return !improves(sum_(g, edge.cost), touch(edge.node)); });
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

/// Checks that tell what motions cost have done so by now.
void AStar::learnCosts()
{
    if (lattice_.motionCosts() == nullptr)
        return;
    for (Edge& edge : successors_.edges)
        edge.cost = lattice_.motionCosts()->known(successors_.innerOf(edge).back().motion());
}

void AStar::relax(NodeId from, const Edge& edge)
{
    Node& end = nodes_[edge.node];
    const double g = sum_(nodes_[from].g, edge.cost);
    if (!improves(g, end))
        return;  // a second motion of this expansion to the same node, or one dearer than its lower bound
    end.g = g;
    end.parent = from;
    open(edge.node);
}

void AStar::open(NodeId id)
{
    Node& node = nodes_[id];
    node.closed = false;
    open_.push(id, {sum_(node.g, weight_ * node.h), node.g, pushes_++});
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
    if (!isAsked(nodes_[node].h))
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
