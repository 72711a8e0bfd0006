// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "specplan/speculation/NearbyVerdicts.h"
#include "specplan/speculation/Predictor.h"

namespace specplan::speculation
{
/// Judges a state by what is known of its neighbours, and learns while the search runs what that is worth.
///
/// Obstacles are larger than a step, so verdicts cluster; how much differs from problem to problem. States are sorted
/// by how many of their neighbours are known to be valid and how many to be invalid, and for each such pair of numbers
/// the predictor counts how the states turned out. Where it is costly to find a node's neighbours, valid states count
/// once the search has gone on from them. Motions are judged by the share of those that were valid.
class LearningPredictor : public Predictor
{
public:
    /// \param lattice must outlive the predictor.
    explicit LearningPredictor(lattice::Lattice& lattice);

    [[nodiscard]] double probabilityValid(lattice::NodeId node) const override;
    [[nodiscard]] double probabilityMotionValid() const override;
    void learned(lattice::NodeId node, bool valid) override;
    void learnedMotion(bool valid) override;
    void left(lattice::NodeId node) override;

private:
    /// How states of one kind turned out; starts with a weak belief.
    struct Record
    {
        double valid;
        double all;
    };

    static constexpr std::size_t kLevels = 9;

    [[nodiscard]] static std::size_t kindOf(const NearbyVerdicts::Counts& counts);
    [[nodiscard]] static std::size_t level(unsigned count);

    const lattice::Lattice& lattice_;
    NearbyVerdicts nearby_;
    std::vector<bool> untold_;  ///< nodes whose neighbours have not been told yet that they are valid
    std::array<Record, kLevels * kLevels> records_;
    Record motions_{9.0, 10.0};
};
}  // namespace specplan::speculation
