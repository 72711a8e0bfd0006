// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/lattice/NodeTable.h"

namespace specplan::speculation
{
/// Guesses verdicts that are not known yet.
class Predictor
{
public:
    virtual ~Predictor() = default;

    /// Whether the state of this node is likely to be valid, when it is met from `from` (whose state is valid or
    /// predicted so).
    [[nodiscard]] virtual bool isLikelyValid(lattice::NodeId from, lattice::NodeId node) const = 0;

    /// A verdict has come in.
    virtual void learned(lattice::NodeId node, bool valid) = 0;
};

/// Takes everything for valid.
class OptimisticPredictor : public Predictor
{
public:
    [[nodiscard]] bool isLikelyValid(lattice::NodeId, lattice::NodeId) const override
    {
        return true;
    }

    void learned(lattice::NodeId, bool) override
    {
    }
};
}  // namespace specplan::speculation
