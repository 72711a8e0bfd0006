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

/// How much later an unlikely node has its turn, for weight 1. Found by experiment: anything from 0.3 to 4 is nearly as
/// good.
constexpr double kCaution = 1.0;

/// Below this probability a node is delayed further.
constexpr double kImprobable = 0.2;

/// The shadow stops at a goal that the search is this likely to reach. Otherwise it goes on: workers would have nothing
/// to do.
constexpr double kSure = 0.9;

/// Number of values that the average step of f remembers.
constexpr double kScaleMemory = 1000.0;
}  // namespace

RunAheadPolicy::RunAheadPolicy(lattice::Lattice& lattice, const validity::Broker& broker, const FrontierView& frontier,
                               Predictor& predictor, double weight)
    : lattice_(lattice),
      broker_(broker),
      frontier_(frontier),
      predictor_(predictor),
      sum_(frontier.sum()),
      caution_(kCaution / std::sqrt(weight))
{
}

void RunAheadPolicy::expanding(NodeId node, NodeId)
{
    expanding_ = node;
    if (imported_)
        behind_.push_back(node);
}

void RunAheadPolicy::propose(std::size_t count, std::vector<CheckId>& out)
{
    synchronise();
    const std::size_t full = out.size() + count;
    const auto first = static_cast<std::ptrdiff_t>(out.size());
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
        if (broker_.verdict(next.check) != Verdict::Unknown || !isClosed(next.from) ||
            std::find(out.begin() + first, out.end(), next.check) != out.end())
            continue;
        if (!next.check.isMotion())
            nodes_[next.check.node()].askedFrom = next.from;
        out.push_back(next.check);
    }
}

bool RunAheadPolicy::stillWanted(CheckId check) const
{
    if (!imported_)
        return true;
    if (check.isMotion())
        return isClosed(lattice_.motion(check.motion()).from);
    return check.node() < nodes_.size() && isClosed(nodes_[check.node()].askedFrom);
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
        node.inner = Inner::None;  // its motion is known to be valid
        node.status = Status::Open;
        open_.push(entry.item, {entry.key.f, entry.key.g, pushes_++});
    }
}

void RunAheadPolicy::missed()
{
    imported_ = false;
    behind_.clear();
    nodes_.clear();
    open_.clear();
    pending_ = {};
    detours_.clear();
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
    node.probability = 1.0;
    node.delay = 0.0;
    node.closedAs = ++expansions_;
    node.parent = frontier_.parent(id);
    node.ofState = 1.0F;
    node.ofMotion = 1.0F;
    node.status = Status::Closed;
    relaxFrom(id);
}

bool RunAheadPolicy::advance()
{
    if (open_.empty())
        return false;
    const NodeId id = open_.top().item;
    const bool goal = frontier_.isGoal(id);
    if (goal && nodes_[id].probability > kSure)
        return false;
    open_.pop();
    nodes_[id].status = Status::Closed;
    nodes_[id].closedAs = ++expansions_;
    if (!goal)
        relaxFrom(id);
    return true;
}

void RunAheadPolicy::relaxFrom(NodeId node)
{
    lattice_.successors(node, successors_);
    makeRoom();  // from here on no node moves
    for (const lattice::Successors::Edge& edge : successors_.edges)
        relax(node, edge);
}

void RunAheadPolicy::relax(NodeId from, const lattice::Successors::Edge& edge)
{
    if (frontier_.isExpanded(edge.node) || edge.node == expanding_)
        return;
    Node& end = touch(edge.node);
    const double g = sum_(nodes_[from].g, costOf(edge));
    const CheckId state = CheckId::ofState(edge.node);
    if (!(g < end.g) || (end.status == Status::Closed && !wouldComeFirst(nodes_[from], end)))
    {
        if (edge.inner > 0 && isTakenBeforeParent(from, end) && g < frontier_.costToCome(edge.node))
            noteDetour(from, edge, g);
        return;
    }
    const Verdict verdict = broker_.verdict(state);
    if (verdict == Verdict::Invalid)
        return;
    if (verdict == Verdict::Unknown)
        emit(state, from);
    const double ofMotion = checkMotion(from, edge, verdict == Verdict::Valid);
    if (ofMotion == 0.0)
        return;
    if (end.inner == Inner::One && end.parent != from && end.parent != lattice::kNoNode)
        detours_[edge.node].push_back({end.motion, end.parent, end.g});
    noteStep(sum_(g, end.h) - estimateThrough(nodes_[from]));
    end.g = g;
    end.parent = from;
    end.inner = edge.inner == 0 ? Inner::None : Inner::More;
    if (edge.inner == 1 && successors_.innerOf(edge).front().isMotion())
    {
        end.inner = Inner::One;
        end.motion = successors_.innerOf(edge).front();
    }
    end.ofState = verdict == Verdict::Valid ? 1.0F : static_cast<float>(predictor_.probabilityValid(edge.node));
    end.ofMotion = static_cast<float>(ofMotion);
    end.probability = nodes_[from].probability * static_cast<double>(end.ofState * end.ofMotion);
    end.delay =
        nodes_[from].delay + delayFor(static_cast<double>(end.ofState)) + delayFor(static_cast<double>(end.ofMotion));
    end.status = Status::Open;
    push(edge.node);
}

/// Whether the search comes to `from` before it comes to the parent of `end`, the better way.
bool RunAheadPolicy::isTakenBeforeParent(NodeId from, const Node& end) const
{
    return end.parent != lattice::kNoNode && !frontier_.isExpanded(end.parent) &&
           wouldComeFirst(nodes_[from], nodes_[end.parent]) && !descends(from, end.parent);
}

/// Whether the shadow's way to `node` leads through `ancestor`, or is it.
bool RunAheadPolicy::descends(NodeId node, NodeId ancestor) const
{
    const std::uint64_t closed = nodes_[ancestor].closedAs;
    while (node != ancestor && node != lattice::kNoNode && nodes_[node].closedAs > closed)
        node = nodes_[node].parent;
    return node == ancestor;
}

/// The search checks a motion as soon as it is the best way so far, though a better one is to come, and so must we.
void RunAheadPolicy::noteDetour(NodeId from, const lattice::Successors::Edge& edge, double g)
{
    const Verdict verdict = broker_.verdict(CheckId::ofState(edge.node));
    const auto inner = successors_.innerOf(edge);
    if (verdict == Verdict::Invalid || inner.size() != 1 || !inner.front().isMotion())
        return;
    std::vector<Detour>& detours = detours_[edge.node];
    for (const Detour& other : detours)
        if (other.g <= g && isClosed(other.from) &&
            (other.from == from || wouldComeFirst(nodes_[other.from], nodes_[from])))
            return;
    detours.push_back({inner.front(), from, g});
    if (verdict == Verdict::Valid && broker_.verdict(inner.front()) == Verdict::Unknown)
        emit(inner.front(), from);
}

/// What a motion costs, as far as that is known.
double RunAheadPolicy::costOf(const lattice::Successors::Edge& edge) const
{
    if (lattice_.motionCosts() == nullptr)
        return edge.cost;
    const CheckId motion = successors_.innerOf(edge).back();
    return broker_.verdict(motion) == Verdict::Valid ? lattice_.motionCosts()->known(motion.motion()) : edge.cost;
}

void RunAheadPolicy::noteStep(double change)
{
    if (!std::isfinite(change))
        return;  // costs that do not add up may begin without bound
    steps_ = std::min(steps_ + 1.0, kScaleMemory);
    scale_ += (std::abs(change) - scale_) / steps_;
}

double RunAheadPolicy::estimateThrough(const Node& node) const
{
    return sum_(node.g, node.h);
}

/// An unlikely node comes later; one that is hardly possible much later, however greedy the search is.
double RunAheadPolicy::delayFor(double probability) const
{
    return std::max(std::log(kImprobable / probability), 0.0) - caution_ * std::log(probability);
}

/// Emits what is unknown of a motion once it is worth it. \return the probability that the motion is valid.
double RunAheadPolicy::checkMotion(NodeId from, const lattice::Successors::Edge& edge, bool endIsValid)
{
    double probability = 1.0;
    for (const CheckId inner : successors_.innerOf(edge))
    {
        guarded_ = guarded_ || !inner.isMotion();
        const Verdict verdict = broker_.verdict(inner);
        if (verdict == Verdict::Invalid)
            return 0.0;
        if (verdict == Verdict::Valid)
            continue;
        if (verdict == Verdict::Unknown && endIsValid)
            emit(inner, from);
        // The states that guard a step lie beside its end: whether they are valid is no second question.
        if (inner.isMotion())
            probability *= predictor_.probabilityMotionValid();
    }
    return probability;
}

void RunAheadPolicy::push(NodeId id)
{
    const Node& node = nodes_[id];
    open_.push(id, {estimateThrough(node) + scale_ * node.delay, node.g, pushes_++});
}

void RunAheadPolicy::emit(CheckId check, NodeId from)
{
    if (!check.isMotion())
        touch(check.node());
    pending_.push({nodes_[from].closedAs, pushes_++, check, from});
}

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
    if (!valid && !check.isMotion() && nodes_[id].status == Status::Open)
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
    raise(id, known);
    emitMotionTo(id);
    const auto found = detours_.find(id);
    if (found == detours_.end())
        return;
    for (const Detour& detour : found->second)
        if (isClosed(detour.from) && broker_.verdict(detour.check) == Verdict::Unknown)
            emit(detour.check, detour.from);
}

void RunAheadPolicy::confirmMotion(NodeId id)
{
    const double known = static_cast<double>(nodes_[id].ofMotion);
    nodes_[id].ofMotion = 1.0F;
    raise(id, known);
}

/// The end is valid: now the inside of the motion to it is worth a check.
void RunAheadPolicy::emitMotionTo(NodeId id)
{
    const NodeId parent = nodes_[id].parent;
    if (parent == lattice::kNoNode || nodes_[id].inner == Inner::None)
        return;
    if (nodes_[id].inner == Inner::One)
    {
        if (broker_.verdict(nodes_[id].motion) == Verdict::Unknown)
            emit(nodes_[id].motion, parent);
        return;
    }
    lattice_.successors(parent, around_);
    for (const lattice::Successors::Edge& edge : around_.edges)
        if (edge.node == id)
            for (const CheckId inner : around_.innerOf(edge))
                if (broker_.verdict(inner) == Verdict::Unknown)
                    emit(inner, parent);
}

/// A probability has become certainty: all that hangs on it is more likely by this factor.
void RunAheadPolicy::raise(NodeId root, double known)
{
    if (known == 1.0)
        return;
    const double delay = delayFor(known);
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
        lattice_.successors(id, around_);
        for (const lattice::Successors::Edge& edge : around_.edges)
            if (isChild(edge.node, id))
                subtree_.push_back(edge.node);
    }
}

void RunAheadPolicy::forget(NodeId id)
{
    Node& node = nodes_[id];
    if (node.status == Status::Open)
        open_.erase(id);
    node.status = Status::Unseen;
    node.g = kUnreached;
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
        lattice_.successors(id, around_);
        for (const lattice::Successors::Edge& edge : around_.edges)
        {
            if (isChild(edge.node, id))
                subtree_.push_back(edge.node);
            else if (isClosed(edge.node))
                rim_.push_back(edge.node);
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

/// Whether the search expands `node` before `other`: then what it learns there comes in time.
bool RunAheadPolicy::wouldComeFirst(const Node& node, const Node& other) const
{
    const double f = estimateThrough(node);
    const double otherF = estimateThrough(other);
    return f != otherF ? f < otherF : node.g > other.g;
}

void RunAheadPolicy::makeRoom()
{
    if (nodes_.size() < lattice_.size())
        nodes_.resize(std::max(lattice_.size(), nodes_.size() * 2));
}

RunAheadPolicy::Node& RunAheadPolicy::touch(NodeId node)
{
    if (node >= nodes_.size())
        makeRoom();
    if (std::isnan(nodes_[node].h))
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
