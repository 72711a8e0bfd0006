// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "specplan/lattice/Lattice.h"
#include "specplan/util/GrowingArray.h"

namespace specplan::speculation
{
/// Counts, for every node, the known verdicts among its neighbours.
class NearbyVerdicts
{
public:
    struct Counts
    {
        std::uint16_t valid = 0;
        std::uint16_t invalid = 0;
    };

    /// \param lattice must outlive this. Its motions have to go both ways, as those of a grid do.
    explicit NearbyVerdicts(lattice::Lattice& lattice);

    [[nodiscard]] Counts around(lattice::NodeId node) const noexcept
    {
        return node < counts_.size() ? counts_[node] : Counts{};
    }

    /// Tells the neighbours of `node` about its verdict.
    void add(lattice::NodeId node, bool valid);

    /// Takes back what `add` did.
    void remove(lattice::NodeId node, bool valid);

private:
    [[nodiscard]] std::uint16_t& countOf(lattice::NodeId node, bool valid);
    void meet(lattice::NodeId node);

    lattice::Lattice& lattice_;
    util::GrowingArray<Counts> counts_;  ///< by node
    std::vector<lattice::NodeId> neighbours_;
};
}  // namespace specplan::speculation
