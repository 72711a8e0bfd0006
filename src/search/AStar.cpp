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
    if (cost < touch(start).g)
        settle(start, cost, pushes_++, lattice::kNoNode);
}

void AStar::addGoal(NodeId goal)
{
    Node& node = touch(goal);
    node.goal = true;
    if (!node.closed)
        return;
    node.closed = false;  // the search has been here, not knowing where it was
    node.age = pushes_++;
    place(goal);
}

void AStar::motionAdded(NodeId from)
{
    if (from >= nodes_.size() || !nodes_[from].closed)
        return;  // an expansion still to come will find it
    nodes_[from].closed = false;
    place(from);
}

void AStar::heuristicChanged()
{
    for (Node& node : nodes_)
        node.h = kNotAsked;
    const std::vector<util::OpenList::Entry> entries(open_.entries().begin(), open_.entries().end());
    for (const util::OpenList::Entry& entry : entries)
    {
        touch(entry.item);
        place(entry.item);
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
        if (nodes_[node].ways != kNoWay)       // 3: the motion to it; if that collides, the next best way there
        {
            if (!confirmWay(node))
                return SearchStatus::Stopped;
            continue;
        }
        if (isGoalNow(node))  // 4: a goal is expanded: done
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
    dropUseless(nodes_[node]);  // 5: closed, or no better than a way already found
    if (!dropInvalid())         // 6: states that collide
        return false;           // interrupted: the node stays on OPEN as it was
    open_.pop();
    nodes_[node].closed = true;
    noteExpansion(node);
    for (const Edge& edge : successors_.edges)  // 7
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
        std::ranges::copy(successors_.guardsOf(edge), std::back_inserter(checks_));
    if (!broker_.demand(checks_))
        return false;
    std::erase_if(successors_.edges,
                  [this](const Edge& edge)
                  {
                      return std::ranges::any_of(successors_.guardsOf(edge), [this](CheckId check)
                                                 { return broker_.verdict(check) == Verdict::Invalid; });
                  });
    return true;
}

void AStar::relax(NodeId from, const Edge& edge)
{
    const double g = sum_(nodes_[from].g, edge.cost);
    if (!improves(g, nodes_[edge.node]))
        return;  // a second motion of this expansion to the same node
    if (const std::optional<CheckId> motion = successors_.motionOf(edge))
        addWay(edge.node, {g, nodes_[from].g, pushes_++, from, *motion, kNoWay});
    else
        settle(edge.node, g, pushes_++, from);
}

/// Asks for the motion that the best way to a node ends with, and draws the consequences.
/// \return false if interrupted.
bool AStar::confirmWay(NodeId node)
{
    const TentativeWay way = ways_[nodes_[node].ways];
    checks_.assign(1, way.motion);
    if (!broker_.demand(checks_))
        return false;
    dropWay(nodes_[node].ways);
    putBestFirst(nodes_[node].ways);
    const bool valid = broker_.verdict(way.motion) == Verdict::Valid;
    double g = way.g;
    if (valid && lattice_.motionCosts() != nullptr)  // so far there was a lower bound; the check has told the cost
        g = sum_(way.parentG, lattice_.motionCosts()->known(way.motion.motion()));
    // Where only the check tells the cost, an older way may turn out to be as good.
    const bool wasFirst = !nodes_[node].closed && g == nodes_[node].g && way.age < nodes_[node].age;
    if (valid && (improves(g, nodes_[node]) || wasFirst))
        settle(node, g, way.age, way.parent);
    else
        place(node);
    return true;
}

/// The best way known to be valid: others that come after it are of no more use.
void AStar::settle(NodeId id, double g, std::uint64_t age, NodeId parent)
{
    Node& node = nodes_[id];
    node.g = g;
    node.age = age;
    node.parent = parent;
    node.closed = false;
    for (std::uint32_t* link = &node.ways; *link != kNoWay;)
    {
        const TentativeWay& way = ways_[*link];
        if (way.g < g || (way.g == g && way.age < age))
            link = &ways_[*link].next;
        else
            dropWay(*link);
    }
    putBestFirst(node.ways);
    place(id);
}

void AStar::addWay(NodeId id, const TentativeWay& way)
{
    std::uint32_t slot = unusedWays_;
    if (slot == kNoWay)
    {
        slot = static_cast<std::uint32_t>(ways_.size());
        ways_.push_back(way);
    }
    else
    {
        unusedWays_ = ways_[slot].next;
        ways_[slot] = way;
    }
    std::uint32_t& first = nodes_[id].ways;
    const bool isBest = first == kNoWay || way.g < ways_[first].g;
    std::uint32_t& link = isBest ? first : ways_[first].next;
    ways_[slot].next = link;
    link = slot;
    if (isBest)
        place(id);
}

/// Brings the best way of a list to its front; of equally good ones that which was found first.
void AStar::putBestFirst(std::uint32_t& first)
{
    std::uint32_t* best = &first;
    for (std::uint32_t* link = &first; *link != kNoWay; link = &ways_[*link].next)
        if (const TentativeWay& way = ways_[*link], &other = ways_[*best];
            way.g < other.g || (way.g == other.g && way.age < other.age))
            best = link;
    if (best == &first)
        return;
    const std::uint32_t way = *best;
    *best = ways_[way].next;
    ways_[way].next = first;
    first = way;
}

/// Takes a way out of its list.
void AStar::dropWay(std::uint32_t& link)
{
    const std::uint32_t way = link;
    link = ways_[way].next;
    ways_[way].next = unusedWays_;
    unusedWays_ = way;
}

/// Place on OPEN before every place that the node may turn out to have. A dearer way has a greater g, hence no smaller
/// f; but where rounding makes f the same, it comes first.
util::OpenKey AStar::earliestKey(const TentativeWay& way, double h) const
{
    const double f = sum_(way.g, weight_ * h);
    return {f, sum_.adds() ? way.g + std::abs(f) * 0x1p-50 : kUnreached, way.age};
}

/// Puts a node on OPEN where its best way belongs, or takes it off.
void AStar::place(NodeId id)
{
    const Node& node = nodes_[id];
    if (node.ways != kNoWay)
        open_.push(id, earliestKey(ways_[node.ways], node.h));
    else if (!node.closed && node.g != kUnreached)
        open_.push(id, {sum_(node.g, weight_ * node.h), node.g, node.age});
    else if (open_.contains(id))
        open_.erase(id);
}

speculation::FrontierView::Way AStar::bestWay(NodeId node) const noexcept
{
    if (node >= nodes_.size())
        return {kUnreached, lattice::kNoNode, std::nullopt};
    if (nodes_[node].ways == kNoWay)
        return {nodes_[node].g, nodes_[node].parent, std::nullopt};
    const TentativeWay& way = ways_[nodes_[node].ways];
    return {way.g, way.parent, way.motion};
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
        nodes_.growTo(lattice_.size());
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
