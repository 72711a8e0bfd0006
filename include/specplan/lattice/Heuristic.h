// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/lattice/NodeTable.h"

namespace specplan::lattice
{
/// Estimate of the cost from a node to the nearest goal.
class Heuristic
{
public:
    virtual ~Heuristic() = default;

    /// At least 0, finite, and always the same for the same node. The search's guarantees hold for consistent ones:
    /// the estimate falls by no more than a motion's cost along that motion, and is 0 at goals.
    [[nodiscard]] virtual double estimate(NodeId node) const = 0;
};
}  // namespace specplan::lattice
