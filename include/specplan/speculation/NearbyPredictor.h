// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/speculation/NearbyVerdicts.h"
#include "specplan/speculation/Predictor.h"

namespace specplan::speculation
{
/// Judges a state by the share of valid ones among the known verdicts of its neighbours. Motions count as valid.
class NearbyPredictor : public OptimisticPredictor
{
public:
    /// \param lattice must outlive the predictor.
    explicit NearbyPredictor(lattice::Lattice& lattice) : nearby_(lattice)
    {
    }

    [[nodiscard]] double probabilityValid(lattice::NodeId node) const override
    {
        // As if two valid states had been seen besides, and a tenth of an invalid one: nothing is certain.
        const NearbyVerdicts::Counts counts = nearby_.around(node);
        return (counts.valid + 2.0) / (counts.valid + counts.invalid + 2.1);
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
    NearbyVerdicts nearby_;
};
}  // namespace specplan::speculation
