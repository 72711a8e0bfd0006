// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/NearbyVerdicts.h"

#include <algorithm>

namespace specplan::speculation
{
void NearbyVerdicts::add(lattice::NodeId node, bool valid)
{
    lattice_.successors(node, neighbours_);
    if (counts_.size() < lattice_.size())
        counts_.resize(std::max(lattice_.size(), counts_.size() * 2));
    for (const lattice::Successors::Edge& edge : neighbours_.edges)
        ++(valid ? counts_[edge.node].valid : counts_[edge.node].invalid);
}
}  // namespace specplan::speculation
