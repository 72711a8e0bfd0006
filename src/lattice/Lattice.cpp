// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/Lattice.h"

#include <stdexcept>

namespace specplan::lattice
{
namespace
{
constexpr MotionId kNoMotion = std::numeric_limits<MotionId>::max();
constexpr std::size_t kMaxMotions = std::size_t{1} << 31;
}  // namespace

Lattice::Lattice(std::unique_ptr<const Neighbourhood> neighbourhood)
    : neighbourhood_(std::move(neighbourhood)), nodes_(neighbourhood_->dimension()), next_(neighbourhood_->dimension())
{
}

NodeId Lattice::addTerminal()
{
    std::vector<Coordinate> mark(dimension(), 0);
    mark[0] = std::numeric_limits<Coordinate>::min() + static_cast<Coordinate>(terminals_++);
    return nodes_.intern(mark.data());
}

std::size_t Lattice::terminalIndex(NodeId node) const noexcept
{
    return static_cast<std::size_t>(static_cast<std::int64_t>(coordinates(node)[0]) -
                                    std::numeric_limits<Coordinate>::min());
}

void Lattice::connect(NodeId from, NodeId to, double cost)
{
    handMade_[from].push_back({to, cost, addMotion(from, to)});
}

MotionId Lattice::addMotion(NodeId from, NodeId to)
{
    if (motions_.size() >= kMaxMotions)
        throw std::length_error("the lattice has more than 2^31 touched motions; choose a coarser resolution");
    *motions_.append() = {from, to};
    return static_cast<MotionId>(motions_.size() - 1);
}

MotionId Lattice::motionsOf(NodeId node)
{
    if (firstMotion_.size() <= node)
        firstMotion_.resize(std::max<std::size_t>(nodes_.size(), firstMotion_.size() * 2), kNoMotion);
    if (firstMotion_[node] == kNoMotion)
    {
        if (motions_.size() + neighbourhood_->maxSteps() >= kMaxMotions)
            throw std::length_error("the lattice has more than 2^31 touched motions; choose a coarser resolution");
        firstMotion_[node] = static_cast<MotionId>(motions_.size());
        motions_.growTo(motions_.size() + neighbourhood_->maxSteps());
        for (std::size_t i = 0; i < steps_.count; ++i)
            motions_[firstMotion_[node] + steps_.steps[i].index].from = node;
    }
    return firstMotion_[node];
}

void Lattice::successors(NodeId node, Successors& out)
{
    out.edges.clear();
    out.inner.clear();
    if (!isTerminal(node))
    {
        const std::size_t n = dimension();
        neighbourhood_->steps(nodes_.coordinates(node).data(), steps_);
        const MotionId first = neighbourhood_->hasMotionChecks() ? motionsOf(node) : 0;
        for (std::size_t i = 0; i < steps_.count; ++i)
        {
            const Steps::Step& step = steps_.steps[i];
            const auto firstInner = static_cast<std::uint32_t>(out.inner.size());
            const NodeId end = nodes_.intern(&steps_.ends[i * n]);
            for (std::size_t guard = 0; guard < step.guards; ++guard)
                out.inner.push_back(CheckId::ofState(nodes_.intern(&steps_.guards[(step.firstGuard + guard) * n])));
            if (step.motionCheck)
            {
                // A motion is written once, before its id leaves: workers may be reading it later on.
                if (Motion& motion = motions_[first + step.index]; motion.to != end)
                    motion.to = end;
                out.inner.push_back(CheckId::ofMotion(first + step.index));
            }
            out.edges.push_back({end, motionCost_ ? motionCost_(node, end) : step.cost, firstInner,
                                 static_cast<std::uint32_t>(out.inner.size()) - firstInner});
        }
    }
    if (handMade_.empty())
        return;
    const auto made = handMade_.find(node);
    if (made == handMade_.end())
        return;
    for (const HandMade& edge : made->second)
    {
        out.edges.push_back({edge.to, edge.cost, static_cast<std::uint32_t>(out.inner.size()), 1});
        out.inner.push_back(CheckId::ofMotion(edge.motion));
    }
}

std::optional<NodeId> Lattice::goOn(NodeId from, NodeId to)
{
    if (isTerminal(from) || isTerminal(to) ||
        !neighbourhood_->goOn(coordinates(from).data(), coordinates(to).data(), next_.data()))
        return std::nullopt;
    return nodes_.intern(next_.data());
}
}  // namespace specplan::lattice
