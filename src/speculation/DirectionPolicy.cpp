// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/DirectionPolicy.h"

#include <algorithm>
#include <optional>

namespace specplan::speculation
{
using lattice::CheckId;
using lattice::NodeId;
using validity::Verdict;

DirectionPolicy::DirectionPolicy(lattice::Lattice& lattice, const validity::Broker& broker, unsigned lookahead)
    : lattice_(lattice), broker_(broker), lookahead_(lookahead)
{
}

void DirectionPolicy::expanding(NodeId node, NodeId parent)
{
    node_ = node;
    parent_ = parent;
}

void DirectionPolicy::propose(std::size_t count, std::vector<CheckId>& out)
{
    if (parent_ == lattice::kNoNode)
        return;
    const std::size_t full = out.size() + count;
    NodeId from = parent_;
    NodeId at = node_;
    for (unsigned step = 0; step < lookahead_ && out.size() < full; ++step)
    {
        const std::optional<NodeId> next = lattice_.goOn(from, at);
        if (!next)
            return;
        from = at;
        at = *next;
        proposeAround(at, full, out);
        if (broker_.verdict(CheckId::ofState(at)) == Verdict::Valid)
            proposeMotion(from, at, full, out);
    }
}

void DirectionPolicy::add(CheckId check, std::size_t full, std::vector<CheckId>& out) const
{
    if (out.size() < full && broker_.verdict(check) == Verdict::Unknown && std::ranges::find(out, check) == out.end())
        out.push_back(check);
}

void DirectionPolicy::proposeAround(NodeId node, std::size_t full, std::vector<CheckId>& out)
{
    lattice_.successors(node, around_);
    for (const lattice::Successors::Edge& edge : around_.edges)
    {
        const CheckId end = CheckId::ofState(edge.node);
        add(end, full, out);
        // What lies beside a motion is of use only once both its ends are known to be valid.
        if (broker_.verdict(end) == Verdict::Valid && broker_.verdict(CheckId::ofState(node)) == Verdict::Valid)
            for (const CheckId guard : around_.guardsOf(edge))
                add(guard, full, out);
    }
}

/// The inside of a motion is asked for when its end comes to be expanded.
void DirectionPolicy::proposeMotion(NodeId from, NodeId to, std::size_t full, std::vector<CheckId>& out)
{
    lattice_.successors(from, around_);
    for (const lattice::Successors::Edge& edge : around_.edges)
        if (const std::optional<CheckId> motion = around_.motionOf(edge); edge.node == to && motion)
            add(*motion, full, out);
}
}  // namespace specplan::speculation
