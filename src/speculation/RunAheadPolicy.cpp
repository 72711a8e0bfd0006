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
/// How much later an unlikely node has its turn, for weight 1. Found by experiment: anything from 0.3 to 4 is nearly as
/// good.
constexpr double kCaution = 1.0;

/// Below this probability a node is delayed further.
constexpr double kImprobable = 0.2;

/// A motion more likely than this delays nothing: many are as likely, ways to a node differ by a few of them, and the
/// order of equally good ways would be lost.
constexpr double kLikelyMotion = 0.8;

/// The shadow stops at a goal that the search is this likely to reach. Otherwise it goes on: workers would have nothing
/// to do.
constexpr double kSure = 0.9;

/// How many steps back two equally long ways are compared.
constexpr int kTieDepth = 100;

/// Costs that differ by less than this share differ by rounding.
constexpr double kRounding = 1e-12;

/// Number of values that the average step of f remembers.
constexpr double kScaleMemory = 1000.0;

bool isTie(double g, double other)
{
    return std::abs(g - other) <= kRounding * std::abs(g);
}
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
        if (broker_.verdict(next.check) != Verdict::Unknown || !leadsOn(next) ||
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
        return isOnTheWay(check);
    return check.node() < nodes_.size() && isClosed(nodes_[check.node()].askedFrom);
}

/// Whether the shadow still gets where it met the check.
bool RunAheadPolicy::leadsOn(const Pending& pending) const
{
    return pending.check.isMotion() ? isOnTheWay(pending.check) : isClosed(pending.from);
}

/// Whether the shadow takes the motion to get to its end, and beyond or to a goal.
bool RunAheadPolicy::isOnTheWay(CheckId motion) const
{
    const lattice::Lattice::Motion& asked = lattice_.motion(motion.motion());
    return asked.to < nodes_.size() && nodes_[asked.to].parent == asked.from &&
           (nodes_[asked.to].status == Status::Closed || frontier_.isGoal(asked.to));
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
        const FrontierView::Way way = frontier_.bestWay(entry.item);
        node.g = way.cost;
        node.parent = way.parent;
        node.motion = way.motion;
        node.ofMotion = way.motion ? static_cast<float>(predictor_.probabilityMotionValid()) : 1.0F;
        node.probability = static_cast<double>(node.ofMotion);
        node.delay = delayForMotion(node.probability);
        node.guarded = false;  // no question any more
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
}

void RunAheadPolicy::follow(NodeId id)
{
    if (moves_)
        followWaysFrom(id);
    Node& node = touch(id);
    node.expandedAs = ++followed_;
    const FrontierView::Way way = frontier_.bestWay(id);
    if (node.status == Status::Closed && node.g <= way.cost)
        return;
    if (node.status == Status::Open)
        open_.erase(id);
    node.g = way.cost;
    node.probability = 1.0;
    node.delay = 0.0;
    node.closedAs = ++expansions_;
    node.parent = way.parent;
    node.ofState = 1.0F;
    node.ofMotion = 1.0F;
    node.status = Status::Closed;
    relaxFrom(id);
}

/// The search takes one of several equally good ways, the shadow maybe another: now it is known which.
void RunAheadPolicy::followWaysFrom(NodeId id)
{
    lattice_.neighbours(id, neighbours_);
    makeRoom();
    const auto isElsewhere = [&](NodeId end)
    {
        if (nodes_[end].status != Status::Closed || frontier_.isExpanded(end))
            return false;
        const FrontierView::Way way = frontier_.bestWay(end);
        return way.parent == id && way.motion && way.motion != nodes_[end].motion;
    };
    if (std::ranges::none_of(neighbours_, isElsewhere))
        return;
    lattice_.successors(id, successors_);
    for (const lattice::Successors::Edge& edge : successors_.edges)
    {
        if (!isElsewhere(edge.node))
            continue;
        Node& end = nodes_[edge.node];
        const FrontierView::Way way = frontier_.bestWay(edge.node);
        if (way.motion != successors_.motionOf(edge) || !isTie(way.cost, end.g))
            continue;
        takeWay(end, id, edge, way.cost);
        emitMotionTo(edge.node, edge.node);
    }
}

bool RunAheadPolicy::advance()
{
    if (open_.empty())
        return false;
    const NodeId id = open_.top().item;
    const bool goal = frontier_.isGoal(id);
    if (goal && nodes_[id].probability > kSure)
    {
        const std::size_t before = pending_.size();
        if (nodes_[id].motion && nodes_[id].motion != motionToGoal_)
            emitMotionTo(id, nodes_[id].parent);
        motionToGoal_ = nodes_[id].motion;
        return pending_.size() > before;
    }
    open_.pop();
    nodes_[id].status = Status::Closed;
    nodes_[id].closedAs = ++expansions_;
    if (broker_.verdict(CheckId::ofState(id)) == Verdict::Valid)
        emitMotionTo(id, id);
    if (!goal)
        relaxFrom(id);
    return true;
}

void RunAheadPolicy::relaxFrom(NodeId node)
{
    lattice_.successors(node, successors_);
    predictor_.left(node);
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
    if (const std::optional<CheckId> motion = successors_.motionOf(edge);
        motion && isTie(g, end.g) && nodes_[from].g < std::min(g, end.g))  // or the tree would get cycles
        return settleTie(from, edge, g, *motion);
    if (!(g < end.g) || (end.status == Status::Closed && !wouldComeFirst(nodes_[from], end)))
        return;
    const CheckId state = CheckId::ofState(edge.node);
    const Verdict verdict = broker_.verdict(state);
    if (verdict == Verdict::Invalid)
        return;
    if (verdict == Verdict::Unknown)
        emit(state, from);
    const double ofMotion = checkMotion(from, edge, verdict == Verdict::Valid);
    if (ofMotion == 0.0)
        return;
    noteStep(sum_(g, end.h) - estimateThrough(nodes_[from]));
    takeWay(end, from, edge, g);
    end.ofState = verdict == Verdict::Valid ? 1.0F : static_cast<float>(predictor_.probabilityValid(edge.node));
    end.ofMotion = static_cast<float>(ofMotion);
    end.probability = nodes_[from].probability * static_cast<double>(end.ofState * end.ofMotion);
    end.delay = nodes_[from].delay + delayFor(static_cast<double>(end.ofState)) +
                delayForMotion(static_cast<double>(end.ofMotion));
    end.status = Status::Open;
    push(edge.node);
}

/// Lets the shadow's way to a node end with this motion. Never makes the node dearer, not even by rounding: with
/// parents that are no dearer than their children the ways are a tree.
void RunAheadPolicy::takeWay(Node& end, NodeId from, const lattice::Successors::Edge& edge, double g)
{
    end.g = std::min(end.g, g);
    end.parent = from;
    end.step = static_cast<std::uint16_t>(&edge - successors_.edges.data());
    end.motion = successors_.motionOf(edge);
    end.guarded = !successors_.guardsOf(edge).empty();
    guarded_ = guarded_ || end.guarded;
    moves_ = moves_ || end.motion;
}

/// Of equally good ways to a node the search takes the one that it finds first, and asks for that one's motion.
void RunAheadPolicy::settleTie(NodeId from, const lattice::Successors::Edge& edge, double g, CheckId motion)
{
    Node& end = nodes_[edge.node];
    if (end.status == Status::Unseen || end.parent == lattice::kNoNode || end.parent == from ||
        broker_.verdict(motion) == Verdict::Invalid || !isFoundBefore(from, g, end))
        return;
    takeWay(end, from, edge, g);
    if (end.status == Status::Closed && broker_.verdict(CheckId::ofState(edge.node)) == Verdict::Valid)
        emitMotionTo(edge.node, edge.node);
}

/// Whether the search comes to `end` from this node rather than from its present parent.
bool RunAheadPolicy::isFoundBefore(NodeId from, double g, const Node& end) const
{
    // Who is expanded after the end itself comes too late.
    const bool inTime = wouldComeFirst(nodes_[from], end);
    const bool parentInTime = wouldComeFirst(nodes_[end.parent], end);
    if (inTime != parentInTime)
        return inTime;
    return inTime && g != end.g ? g < end.g : isExpandedBefore(from, end.parent);
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

double RunAheadPolicy::delayForMotion(double probability) const
{
    return probability > kLikelyMotion ? 0.0 : delayFor(probability);
}

/// Emits the unknown guards of a motion once they are worth it. \return the probability that the motion is valid.
double RunAheadPolicy::checkMotion(NodeId from, const lattice::Successors::Edge& edge, bool endIsValid)
{
    double probability = 1.0;
    for (const CheckId inner : successors_.innerOf(edge))
    {
        const Verdict verdict = broker_.verdict(inner);
        if (verdict == Verdict::Invalid)
            return 0.0;
        if (verdict == Verdict::Valid)
            continue;
        // The states that guard a step lie beside its end: whether they are valid is no second question.
        if (inner.isMotion())
            probability *= predictor_.probabilityMotionValid();
        else if (verdict == Verdict::Unknown && endIsValid)
            emit(inner, from);
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

/// The shadow goes on from the end of this motion, and the end is valid: so the search will ask for its inside.
void RunAheadPolicy::emitMotionTo(NodeId id, NodeId from)
{
    if (nodes_[id].motion && broker_.verdict(*nodes_[id].motion) == Verdict::Unknown)
        emit(*nodes_[id].motion, from);
}

/// Whether the search expands `node` before `other`, as far as the shadow can tell.
bool RunAheadPolicy::isExpandedBefore(NodeId node, NodeId other) const
{
    for (int depth = 0; depth < kTieDepth && node != other; ++depth)
    {
        const Node& a = nodes_[node];
        const Node& b = nodes_[other];
        if (a.expandedAs != b.expandedAs)
            return a.expandedAs != 0 && (b.expandedAs == 0 || a.expandedAs < b.expandedAs);
        if (const double f = estimateThrough(a), otherF = estimateThrough(b); f != otherF)
            return f < otherF;
        if (a.g != b.g)
            return a.g > b.g;
        // The older one: that whose parent was expanded first, or that comes first among the steps of one parent.
        if (a.parent == b.parent)
            return a.step < b.step;
        if (a.parent == lattice::kNoNode || b.parent == lattice::kNoNode)
            return a.parent == lattice::kNoNode;
        node = a.parent;
        other = b.parent;
    }
    return false;
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
            const FrontierView::Way way = frontier_.bestWay(node);
            nodes_[node].g = way.cost;
            nodes_[node].parent = way.parent;
        }
    }
    return nodes_[node];
}
}  // namespace specplan::speculation
