// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/lattice/NodeTable.h"

namespace specplan::speculation
{
/// Guesses verdicts that are not known yet.
///
/// Threads: search thread only.
class Predictor
{
public:
    virtual ~Predictor() = default;

    /// How likely the state of this node is to be valid, given that the search meets it: above 0, at most 1.
    [[nodiscard]] virtual double probabilityValid(lattice::NodeId node) const = 0;

    /// How likely the inside of a motion is to be valid, given that both its ends are: above 0, at most 1.
    [[nodiscard]] virtual double probabilityMotionValid() const = 0;

    /// A state's verdict has come in.
    virtual void learned(lattice::NodeId node, bool valid) = 0;

    /// The verdict of the inside of a motion has come in.
    virtual void learnedMotion(bool valid) = 0;

    /// All successors of a node have been met.
    virtual void left(lattice::NodeId)
    {
    }
};

/// Takes everything for valid.
class OptimisticPredictor : public Predictor
{
public:
    [[nodiscard]] double probabilityValid(lattice::NodeId) const override
    {
        return 1.0;
    }

    [[nodiscard]] double probabilityMotionValid() const override
    {
        return 1.0;
    }

    void learned(lattice::NodeId, bool) override
    {
    }

    void learnedMotion(bool) override
    {
    }
};
}  // namespace specplan::speculation
