// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "specplan/lattice/Heuristic.h"
#include "specplan/lattice/Lattice.h"
#include "specplan/validity/Checker.h"

namespace specplan::benchmarks
{
struct BaselineResult
{
    std::uint64_t checks = 0;
    double cost = 0.0;
};

/// What a lazy search is compared with: the lazy weighted A* of Cohen, Phillips and Likhachev 2014, sequential. A node
/// stays on OPEN once for each way into it; its state, and the inside of the motion, are checked when it comes off.
/// Smaller f = g + weight h first, then larger g, then the cheaper last motion.
[[nodiscard]] BaselineResult lazyAStar(lattice::Lattice& lattice, const lattice::Heuristic& heuristic,
                                       validity::Checker& checker, lattice::NodeId start, lattice::NodeId goal,
                                       double weight);
}  // namespace specplan::benchmarks
