// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/NearbyVerdicts.h"

namespace specplan::speculation
{
namespace
{
/// With more neighbours than this, telling them all costs more than it is worth.
constexpr std::uint32_t kMostNeighbours = 40;
}  // namespace

NearbyVerdicts::NearbyVerdicts(lattice::Lattice& lattice) : lattice_(lattice)
{
}

void NearbyVerdicts::add(lattice::NodeId node, bool valid)
{
    meet(node);
    for (const lattice::NodeId neighbour : neighbours_)
        ++countOf(neighbour, valid);
}

void NearbyVerdicts::remove(lattice::NodeId node, bool valid)
{
    meet(node);
    for (const lattice::NodeId neighbour : neighbours_)
        --countOf(neighbour, valid);
}

void NearbyVerdicts::meet(lattice::NodeId node)
{
    neighbours_.clear();
    if (lattice_.maxSteps() > kMostNeighbours)
        return;
    lattice_.neighbours(node, neighbours_);
    counts_.growTo(lattice_.size());
}

std::uint16_t& NearbyVerdicts::countOf(lattice::NodeId node, bool valid)
{
    return valid ? counts_[node].valid : counts_[node].invalid;
}
}  // namespace specplan::speculation
