// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/NearbyVerdicts.h"

#include <algorithm>

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
    if (lattice_.maxSteps() > kMostNeighbours)
        return;
    lattice_.successors(node, neighbours_);
    if (counts_.size() < lattice_.size())
        counts_.resize(std::max(lattice_.size(), counts_.size() * 2));
    for (const lattice::Successors::Edge& edge : neighbours_.edges)
        ++(valid ? counts_[edge.node].valid : counts_[edge.node].invalid);
}
}  // namespace specplan::speculation
