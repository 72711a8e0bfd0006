// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/LazyTree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "specplan/util/Hash.h"

namespace specplan::search
{
using validity::Verdict;

namespace
{
/// Rounding changes a step of average length by less than this share of it.
constexpr int kUnitBits = 36;

/// Among equally good entries the one comes first whose predecessor is the nearest to a goal: so of equally short paths
/// one is followed to its end. This share of the predecessor's estimate is added to f; it is more than rounding does to
/// the costs, and nobody notices it in the cost of the path.
constexpr double kTieShare = 0x1p-33;
}  // namespace

LazyTree::LazyTree(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, double weight)
    : lattice_(lattice), heuristic_(heuristic), weight_(weight)
{
}

void LazyTree::addStart(NodeId start)
{
    if (unit_ == 0.0)
        chooseUnit(start);
    Node& node = touch(start);
    node.start = true;
    node.verdict = Verdict::Valid;
    set(start, node.g, 0.0, kNoEdge);
}

void LazyTree::addGoal(NodeId goal)
{
    if (isGoal(goal))
        return;
    touch(goal).goal = true;
    goals_.push_back(goal);
    goalsChanged_ = true;
}

/// From the steps out of a start, or from the way to go if that is very much longer: its sums have to stay exact.
void LazyTree::chooseUnit(NodeId start)
{
    lattice_.successors(start, successors_);
    double scale = heuristic_.estimate(start) * 0x1p-10;
    for (const lattice::Successors::Edge& edge : successors_.edges)
        scale = std::max(scale, edge.cost);
    int exponent = 0;
    (void)std::frexp(scale > 0.0 ? scale : 1.0, &exponent);
    unit_ = std::ldexp(1.0, exponent - kUnitBits);
}

double LazyTree::rounded(double cost) const noexcept
{
    return std::max(std::nearbyint(cost / unit_), 1.0) * unit_;
}

NodeId LazyTree::nearestGoal()
{
    if (!goalsChanged_)
        return nearestGoal_;
    goalsChanged_ = false;
    nearestGoal_ = lattice::kNoNode;
    for (const NodeId goal : goals_)
    {
        const double best = nearestGoal_ == lattice::kNoNode ? kUnreached : nodes_[nearestGoal_].g;
        if (nodes_[goal].g < best ||
            (nodes_[goal].g == best && best < kUnreached &&
             std::ranges::lexicographical_compare(lattice_.coordinates(goal), lattice_.coordinates(nearestGoal_))))
            nearestGoal_ = goal;
    }
    return nearestGoal_;
}

/// Whether nothing on OPEN can shorten the way to the nearest goal.
bool LazyTree::isDone()
{
    const util::OpenKey& first = open_.top().key;
    if (first.f == kUnreached)
        return true;
    const NodeId goal = nearestGoal();
    if (goal == lattice::kNoNode)
        return false;
    const double g = nodes_[goal].g;
    return nodes_[goal].rhs == g && first.f >= g;
}

LazyTree::Repair LazyTree::repair(std::size_t budget)
{
    for (std::size_t i = 0; i < lost_.size(); ++i)
    {
        fetch(i + 4);
        look(lost_[i]);
    }
    lost_.clear();
    for (; !open_.empty() && !isDone(); --budget)
    {
        if (budget == 0)
            return Repair::Unfinished;
        const NodeId first = open_.top().item;
        if (nodes_[first].verdict == Verdict::Unknown && doubt_ && doubt_(first))
            return Repair::Doubtful;
        expand(first);
    }
    return Repair::Done;
}

void LazyTree::doubtful(std::size_t count, std::vector<NodeId>& out)
{
    out.clear();
    open_.visitFirst(count,
                     [&](const OpenEntry& entry)
                     {
                         if (isDoubtful(entry))
                             out.push_back(entry.item);
                     });
}

bool LazyTree::isDoubtful(const OpenEntry& entry) const
{
    return nodes_[entry.item].verdict == Verdict::Unknown && entry.key.f < kUnreached && doubt_(entry.item);
}

/// A better way to the node was found: passes it on.
void LazyTree::expand(NodeId id)
{
    ++expansions_;
    connect(id);
    set(id, nodes_[id].rhs, nodes_[id].rhs, nodes_[id].via);
    const double g = nodes_[id].g;
    const EdgeId first = nodes_[id].firstOut;
    const EdgeId end = first + nodes_[id].out;
    for (EdgeId e = first; e < end; ++e)
    {
        const Edge& edge = edges_[e];
        Node& to = nodes_[edge.to];
        const double cost = g + edge.cost;
        to.tied = to.tied || cost == to.rhs;
        if (!(cost < to.rhs) || (weight_ > 1.0 && to.g < kUnreached))
            continue;
        if (const double rhs = g + costOf(edge); rhs < to.rhs)
            set(edge.to, to.g, rhs, e);
    }
}

/// The way to the node may be lost: so may be those of all that came through it. They look for others when it is known
/// which are lost; that may wait for more verdicts.
void LazyTree::lose(NodeId id)
{
    forsaken_.clear();
    forsake(id);
    for (std::size_t i = 0; i < forsaken_.size(); ++i)
    {
        const Node& node = nodes_[forsaken_[i]];
        for (EdgeId e = node.firstOut, end = e + node.out; e < end; ++e)
            if (nodes_[edges_[e].to].via == e)
                forsake(edges_[e].to);
    }
}

/// Finds another way of the same cost into a node, or counts it among the lost.
void LazyTree::forsake(NodeId id)
{
    const Node& node = nodes_[id];
    if (node.start || node.rhs == kUnreached)
        return;
    if (const EdgeId via = node.tied ? bestInto(id) : kNoEdge; via != kNoEdge)
    {
        set(id, node.g, node.rhs, via);
        return;
    }
    if (node.g < kUnreached)
        forsaken_.push_back(id);
    set(id, kUnreached, kUnreached, kNoEdge);
    lost_.push_back(id);
}

/// Brings what look() will need of one of the lost into the cache: most of their time would go into waiting for that.
void LazyTree::fetch(std::size_t lost) const noexcept
{
    if (lost + 4 < lost_.size())
        __builtin_prefetch(&details_[lost_[lost + 4]]);
    if (lost < lost_.size())
        for (const Into& into : into_.items(details_[lost_[lost]].into))
            __builtin_prefetch(&into);
}

/// Finds the best way into a node that has none.
void LazyTree::look(NodeId id)
{
    const Node& node = nodes_[id];
    if (node.rhs != kUnreached || node.verdict == Verdict::Invalid)
        return;
    double rhs = kUnreached;
    EdgeId via = kNoEdge;
    bool tied = false;
    // In no particular order: which of equals is taken must not depend on it.
    for (const Into& into : into_.items(details_[id].into))
    {
        const double g = nodes_[into.from].g;
        if (!(g + into.cost <= rhs) || g == kUnreached)
            continue;
        const double cost = g + costOf(edges_[into.edge]);
        if (cost == kUnreached)
            continue;
        tied = cost == rhs;
        if (cost < rhs || isPreferred(into.edge, via))
        {
            rhs = cost;
            via = into.edge;
        }
    }
    set(id, node.g, rhs, via);
    nodes_[id].tied = tied;
}

void LazyTree::set(NodeId id, double g, double rhs, EdgeId via)
{
    Node& node = nodes_[id];
    if (journal_ != nullptr && details_[id].recorded != journals_)
    {
        details_[id].recorded = journals_;
        journal_->push_back({node.g, node.rhs, id, node.via});
    }
    node.tied = node.tied && rhs == node.rhs;
    node.g = g;
    node.rhs = rhs;
    node.via = via;
    place(id);
}

/// Puts a node on OPEN if it is inconsistent, and takes it off if not.
void LazyTree::place(NodeId id)
{
    const Node& node = nodes_[id];
    goalsChanged_ = goalsChanged_ || node.goal;
    if (node.g != node.rhs)
    {
        const double g = std::min(node.g, node.rhs);
        const Details& details = details_[id];
        const double before = node.via == kNoEdge ? details.h : details_[edges_[node.via].from].h;
        open_.push(id, {g + details.h + kTieShare * before, -g, details.rank});
    }
    else if (open_.contains(id))
        open_.erase(id);
}

/// Asks for the motions out of a node, the first time.
void LazyTree::connect(NodeId id)
{
    if (nodes_[id].firstOut != kNoEdge)
        return;
    lattice_.successors(id, successors_);
    if (edges_.size() + successors_.edges.size() >= kNoEdge || inner_.size() + successors_.inner.size() >= kOnlyMotion)
        throw std::length_error("a lazy search has more than 2^32 touched motions; choose a coarser resolution");
    nodes_[id].firstOut = static_cast<EdgeId>(edges_.size());
    nodes_[id].out = static_cast<std::uint16_t>(successors_.edges.size());
    for (const lattice::Successors::Edge& motion : successors_.edges)
    {
        touch(motion.node);
        Edge& edge = *edges_.append();
        edge = {rounded(motion.cost), id, motion.node, keepInner(successors_.innerOf(motion))};
        into_.append(details_[motion.node].into, {edge.cost, id, static_cast<EdgeId>(edges_.size() - 1)});
    }
}

/// Keeps the checks of a motion. One that has nothing but a check of its own, as most have, takes no place.
std::uint32_t LazyTree::keepInner(std::span<const CheckId> inner)
{
    if (inner.empty())
        return 0;
    if (inner.size() == 1 && inner.front().isMotion())
        return kOnlyMotion | inner.front().motion();
    if (inner_.empty())
    {
        inner_.resize(1);  // 0 means none
        innerCounts_.resize(1);
    }
    const auto first = static_cast<std::uint32_t>(inner_.size());
    for (std::size_t i = 0; i < inner.size(); ++i)
    {
        inner_.push_back(inner[i]);
        innerCounts_.push_back(static_cast<std::uint32_t>(inner.size() - i));
    }
    return first;
}

void LazyTree::addInner(EdgeId edge, std::vector<CheckId>& out) const
{
    const std::uint32_t first = edges_[edge].inner;
    if ((first & kOnlyMotion) != 0)
        out.push_back(CheckId::ofMotion(first & ~kOnlyMotion));
    else if (first != 0)
        out.insert(out.end(), inner_.begin() + first, inner_.begin() + first + innerCounts_[first]);
}

double LazyTree::costOf(const Edge& edge) const noexcept
{
    return nodes_[edge.to].verdict == Verdict::Invalid || isClosed(edge) ? kUnreached : edge.cost;
}

/// Whether something inside or beside the motion is known to be invalid.
bool LazyTree::isClosed(const Edge& edge) const noexcept
{
    if (edge.inner == 0)
        return false;
    if ((edge.inner & kOnlyMotion) != 0)
        return verdict(CheckId::ofMotion(edge.inner & ~kOnlyMotion)) == Verdict::Invalid;
    for (std::uint32_t i = edge.inner, end = i + innerCounts_[i]; i < end; ++i)
        if (verdict(inner_[i]) == Verdict::Invalid)
            return true;
    return false;
}

bool LazyTree::findPath(std::vector<EdgeId>& path)
{
    path.clear();
    for (NodeId node = nearestGoal(); !nodes_[node].start;)
    {
        const EdgeId best = nodes_[node].via;
        if (costOf(edges_[best]) == kUnreached)
        {
            lose(node);
            return false;
        }
        path.push_back(best);
        node = edges_[best].from;
    }
    return true;
}

/// The motion by which the shortest path comes into a node; kNoEdge if its values no longer hold.
LazyTree::EdgeId LazyTree::bestInto(NodeId id) const
{
    const Node& node = nodes_[id];
    EdgeId best = kNoEdge;
    for (const Into& into : into_.items(details_[id].into))
        if (nodes_[into.from].g + into.cost <= node.rhs &&
            nodes_[into.from].g + costOf(edges_[into.edge]) == node.rhs &&
            (best == kNoEdge || isPreferred(into.edge, best)))
            best = into.edge;
    return best;
}

bool LazyTree::isPreferred(EdgeId edge, EdgeId other) const
{
    const NodeId a = edges_[edge].from;
    const NodeId b = edges_[other].from;
    return a == b ? edge < other
                  : std::ranges::lexicographical_compare(lattice_.coordinates(a), lattice_.coordinates(b));
}

bool LazyTree::comesBefore(NodeId node, NodeId other) const
{
    const double g = nodes_[node].g;
    const double otherG = nodes_[other].g;
    return g != otherG ? g < otherG
                       : std::ranges::lexicographical_compare(lattice_.coordinates(node), lattice_.coordinates(other));
}

bool LazyTree::comesThrough(NodeId node, std::span<const NodeId> others) const
{
    if (others.empty())
        return false;
    const double least = nodes_[others.front()].g;
    while (!nodes_[node].start && nodes_[node].via != kNoEdge)
    {
        node = edges_[nodes_[node].via].from;
        if (nodes_[node].g < least)
            return false;
        if (std::ranges::find(others, node) != others.end())
            return true;
    }
    return false;
}

void LazyTree::enter(CheckId check, bool valid)
{
    const Verdict verdict = valid ? Verdict::Valid : Verdict::Invalid;
    if (check.isMotion())
    {
        motions_[check.motion()] = verdict;
        if (!valid)
        {
            motions_[lattice_.glancedAt(check.motion())] = verdict;  // a glance closes the motion that it is of
            lose(lattice_.motion(check.motion()).to);
        }
        return;
    }
    const NodeId node = check.node();
    touch(node).verdict = verdict;
    if (!valid)
        lose(node);
}

Verdict LazyTree::verdict(CheckId check) const noexcept
{
    if (check.isMotion())
    {
        const Verdict* verdict = motions_.find(check.motion());
        return verdict != nullptr ? *verdict : Verdict::Unknown;
    }
    return check.node() < nodes_.size() ? nodes_[check.node()].verdict : Verdict::Unknown;
}

void LazyTree::record(Journal* journal)
{
    journal_ = journal;
    ++journals_;
}

void LazyTree::undo(CheckId check, const Journal& journal)
{
    assert(journal_ == nullptr);
    // Backwards: a node may have been recorded twice, and its first values count.
    for (auto change = journal.rbegin(); change != journal.rend(); ++change)
    {
        Node& node = nodes_[change->node];
        node.g = change->g;
        node.rhs = change->rhs;
        node.via = change->via;
        node.tied = true;  // perhaps
        place(change->node);
        if (node.rhs == kUnreached)
            lost_.push_back(change->node);  // it may have been, and have looked for another way since
    }
    if (check.isMotion())
    {
        if (motions_[check.motion()] == Verdict::Invalid)
            motions_[lattice_.glancedAt(check.motion())] = Verdict::Unknown;
        motions_[check.motion()] = Verdict::Unknown;
    }
    else
        nodes_[check.node()].verdict = Verdict::Unknown;
}

LazyTree::Node& LazyTree::touch(NodeId id)
{
    if (id >= nodes_.size())
    {
        nodes_.growTo(lattice_.size());
        details_.growTo(lattice_.size());
    }
    if (Details& details = details_[id]; details.h < 0.0)
    {
        details.h = weight_ * heuristic_.estimate(id);
        details.rank = util::hashCoordinates(lattice_.coordinates(id));
    }
    return nodes_[id];
}
}  // namespace specplan::search
