// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/Lattice.h"

#include <algorithm>
#include <stdexcept>

namespace specplan::lattice
{
namespace
{
constexpr MotionId kNoMotion = std::numeric_limits<MotionId>::max();
constexpr std::size_t kMaxMotions = std::size_t{1} << 31;
}  // namespace

Lattice::Lattice(std::unique_ptr<const Neighbourhood> neighbourhood)
    : neighbourhood_(std::move(neighbourhood)),
      nodes_(neighbourhood_->dimension()),
      tables_(*neighbourhood_),
      next_(neighbourhood_->dimension())
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

void Lattice::setNeighbourhood(std::unique_ptr<const Neighbourhood> neighbourhood, int level)
{
    if (level == level_)
        tables_ = StepTables(*neighbourhood);
    else
    {
        const auto known = otherTables_.try_emplace(level, *neighbourhood).first;
        otherTables_.insert_or_assign(level_, std::move(tables_));
        tables_ = std::move(known->second);
        otherTables_.erase(known);
    }
    neighbourhood_ = std::move(neighbourhood);
    level_ = level;
}

void Lattice::connect(NodeId from, NodeId to, double cost)
{
    std::vector<HandMade>& made = handMade_[from];
    const auto there = std::ranges::find(made, to, &HandMade::to);
    if (there == made.end())
        made.push_back({to, cost, addMotion(from, to), true});
    else
        *there = {to, cost, there->motion, true};
}

void Lattice::disconnectAll()
{
    for (auto& [from, made] : handMade_)
        for (HandMade& edge : made)
            edge.connected = false;
}

MotionId Lattice::addMotion(NodeId from, NodeId to)
{
    if (motions_.size() >= kMaxMotions)
        throw std::length_error("the lattice has more than 2^31 touched motions; choose a coarser resolution");
    *motions_.append() = {from, to};
    if (motionCosts_ != nullptr)
        motionCosts_->makeRoom(motions_.size());
    return static_cast<MotionId>(motions_.size() - 1);
}

MotionId Lattice::motionsOf(NodeId node)
{
    if (tables_.firstMotion.size() <= node)
        tables_.firstMotion.resize(std::max<std::size_t>(nodes_.size(), tables_.firstMotion.size() * 2), kNoMotion);
    if (tables_.firstMotion[node] == kNoMotion)
    {
        const std::size_t width = std::size_t{neighbourhood_->maxSteps()} * (glances_ ? 2 : 1);
        if (motions_.size() + width >= kMaxMotions)
            throw std::length_error("the lattice has more than 2^31 touched motions; choose a coarser resolution");
        const auto first = static_cast<MotionId>(motions_.size());
        tables_.firstMotion[node] = first;
        motions_.growTo(motions_.size() + width);
        if (motionCosts_ != nullptr)
            motionCosts_->makeRoom(motions_.size());
        for (std::size_t i = 0; i < steps_.count; ++i)
        {
            const MotionId motion = first + steps_.steps[i].index;
            motions_[motion].from = node;
            if (glances_)
                motions_[motion + neighbourhood_->maxSteps()] = {motion, kGlance};
        }
    }
    return tables_.firstMotion[node];
}

std::optional<MotionId> Lattice::glanceOf(MotionId motion) const noexcept
{
    const std::size_t glance = std::size_t{motion} + maxSteps();
    if (!glances_ || glance >= motions_.size() || motions_[glance].to != kGlance || motions_[glance].from != motion)
        return std::nullopt;
    return static_cast<MotionId>(glance);
}

void Lattice::successors(NodeId node, Successors& out)
{
    out.edges.clear();
    out.inner.clear();
    if (!isTerminal(node))
    {
        const std::span<const Neighbourhood::Pattern> patterns = neighbourhood_->patterns();
        if (patterns.empty())
            addSteps(node, out);
        else
            addPatterns(node, patterns, out);
    }
    if (!handMade_.empty())
        addHandMade(node, out);
}

/// Finds the ends of a node's steps, and remembers them.
void Lattice::meet(NodeId node)
{
    neighbourhood_->steps(nodes_.coordinates(node).data(), steps_);
    if (needsMotions())
    {
        const MotionId first = motionsOf(node);
        internEnds([this, first](std::uint32_t step) -> NodeId& { return motions_[first + step].to; });
        return;
    }
    NodeId* ends = tables_.ends.has(node) ? tables_.ends.find(node) : tables_.ends.make(node);
    internEnds([ends](std::uint32_t step) -> NodeId& { return ends[step]; });
}

/// Finds the ends of all steps. An end is written once: workers may be reading that of a motion later on.
template <typename KnownEnd>
void Lattice::internEnds(KnownEnd known)
{
    constexpr std::size_t kAhead = 8;
    const std::size_t n = dimension();
    unknown_.clear();
    for (std::size_t i = 0; i < steps_.count; ++i)
        if (known(steps_.steps[i].index) == kNoNode)
            unknown_.push_back({nodes_.hashOf(&steps_.ends[i * n]), i});
    for (std::size_t i = 0; i < unknown_.size(); ++i)
    {
        if (i + kAhead < unknown_.size())
            nodes_.fetchRow(unknown_[i + kAhead].hash);
        const auto& [hash, step] = unknown_[i];
        known(steps_.steps[step].index) = nodes_.intern(&steps_.ends[step * n], hash);
    }
}

/// Steps that depend on where they start.
void Lattice::addSteps(NodeId node, Successors& out)
{
    meet(node);
    const bool storesMotions = needsMotions();
    const MotionId first = storesMotions ? motionsOf(node) : 0;
    const NodeId* ends = storesMotions ? nullptr : tables_.ends.find(node);
    for (std::size_t i = 0; i < steps_.count; ++i)
    {
        const Steps::Step& step = steps_.steps[i];
        const auto firstInner = static_cast<std::uint32_t>(out.inner.size());
        const NodeId end = storesMotions ? motions_[first + step.index].to : ends[step.index];
        if (step.motionCheck || motionCosts_ != nullptr)
            out.inner.push_back(CheckId::ofMotion(first + step.index));
        out.edges.push_back(
            {end, costOf(node, end, step.cost), firstInner, static_cast<std::uint32_t>(out.inner.size()) - firstInner});
    }
}

/// Steps that are the same everywhere: once the ends are known there is nothing left to be computed.
void Lattice::addPatterns(NodeId node, std::span<const Neighbourhood::Pattern> patterns, Successors& out)
{
    if (!knowsNeighbours(node))
        meet(node);
    if (needsMotions())
    {
        const MotionId first = tables_.firstMotion[node];
        addPatterns(
            node, patterns, first, [this, first](std::uint32_t step) { return motions_[first + step].to; }, out);
    }
    else
    {
        const NodeId* ends = tables_.ends.find(node);
        addPatterns(
            node, patterns, 0, [ends](std::uint32_t step) { return ends[step]; }, out);
    }
}

template <typename EndOf>
void Lattice::addPatterns(NodeId node, std::span<const Neighbourhood::Pattern> patterns, MotionId first, EndOf endOf,
                          Successors& out) const
{
    const bool checksAll = motionCosts_ != nullptr;
    const bool costsAsTheStep = motionCosts_ == nullptr && !stepCost_;
    for (std::uint32_t step = 0; step < patterns.size(); ++step)
    {
        const NodeId end = endOf(step);
        if (end == kNoNode)
            continue;
        const Neighbourhood::Pattern& pattern = patterns[step];
        const auto firstInner = static_cast<std::uint32_t>(out.inner.size());
        for (const std::uint32_t guard : pattern.guards)
            out.inner.push_back(CheckId::ofState(endOf(guard)));
        if (pattern.motionCheck || checksAll)
            out.inner.push_back(CheckId::ofMotion(first + step));
        out.edges.push_back({end, costsAsTheStep ? pattern.cost : costOf(node, end, pattern.cost), firstInner,
                             static_cast<std::uint32_t>(out.inner.size()) - firstInner});
    }
}

bool Lattice::hasMotions(NodeId node) const noexcept
{
    return node < tables_.firstMotion.size() && tables_.firstMotion[node] != kNoMotion;
}

void Lattice::neighbours(NodeId node, std::vector<NodeId>& out)
{
    out.clear();
    if (!isTerminal(node))
        addEnds(node, out);
    if (const auto made = handMade_.find(node); made != handMade_.end())
        for (const HandMade& edge : made->second)
            if (edge.connected)
                out.push_back(edge.to);
}

/// The ends of the steps, without what they cost.
void Lattice::addEnds(NodeId node, std::vector<NodeId>& out)
{
    if (!knowsNeighbours(node))
        meet(node);
    const auto add = [&out](NodeId end)
    {
        if (end != kNoNode)
            out.push_back(end);
    };
    if (needsMotions())
        for (MotionId motion = tables_.firstMotion[node], last = motion + maxSteps(); motion != last; ++motion)
            add(motions_[motion].to);
    else
        std::for_each_n(tables_.ends.find(node), tables_.ends.width(), add);
}

void Lattice::addHandMade(NodeId node, Successors& out) const
{
    const auto made = handMade_.find(node);
    if (made == handMade_.end())
        return;
    for (const HandMade& edge : made->second)
    {
        if (!edge.connected)
            continue;
        const double cost = motionCosts_ != nullptr ? motionCosts_->lowerBound(node, edge.to) : edge.cost;
        out.edges.push_back({edge.to, cost, static_cast<std::uint32_t>(out.inner.size()), 1});
        out.inner.push_back(CheckId::ofMotion(edge.motion));
    }
}

double Lattice::costOf(NodeId from, NodeId to, double ofStep) const
{
    if (motionCosts_ != nullptr)
        return motionCosts_->lowerBound(from, to);
    return stepCost_ ? stepCost_(from, to) : ofStep;
}

std::optional<NodeId> Lattice::goOn(NodeId from, NodeId to)
{
    if (isTerminal(from) || isTerminal(to) ||
        !neighbourhood_->goOn(coordinates(from).data(), coordinates(to).data(), next_.data()))
        return std::nullopt;
    return nodes_.intern(next_.data());
}
}  // namespace specplan::lattice
