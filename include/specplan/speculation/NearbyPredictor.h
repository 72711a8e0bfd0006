// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "specplan/speculation/NearbyVerdicts.h"
#include "specplan/speculation/Predictor.h"

namespace specplan::speculation
{
/// Judges a state by the share of valid ones among the known verdicts of its neighbours. Motions count as valid.
class NearbyPredictor : public OptimisticPredictor
{
public:
    /// \param lattice must outlive the predictor.
    explicit NearbyPredictor(lattice::Lattice& lattice)
        : nearby_(lattice), leastInvalid_(std::max(1U, lattice.maxSteps() / 8))
    {
    }

    [[nodiscard]] double probabilityValid(lattice::NodeId node) const override
    {
        // As if two valid states had been seen besides, and a tenth of an invalid one: nothing is certain.
        const NearbyVerdicts::Counts counts = nearby_.around(node);
        return (counts.valid + 2.0) / (counts.valid + counts.invalid + 2.1);
    }

    /// Whether so many of the state's neighbours are invalid that an obstacle may well go on here: an eighth of them,
    /// as at the end of a thin wall, and not far fewer than valid ones.
    [[nodiscard]] bool isDoubtful(lattice::NodeId node) const
    {
        return nearby_.around(node).invalid >= leastInvalid_ && probabilityValid(node) < kSure;
    }

    void learned(lattice::NodeId node, bool valid) override
    {
        nearby_.add(node, valid);
    }

    /// Takes back what `learned` did.
    void forget(lattice::NodeId node, bool valid)
    {
        nearby_.remove(node, valid);
    }

private:
    /// A state that is likelier to be valid than this is not doubtful.
    static constexpr double kSure = 0.9;

    NearbyVerdicts nearby_;
    std::uint32_t leastInvalid_;  ///< neighbours that make a state doubtful
};
}  // namespace specplan::speculation
