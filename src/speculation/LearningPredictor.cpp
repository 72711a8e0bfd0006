// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/LearningPredictor.h"

#include <algorithm>
#include <bit>

namespace specplan::speculation
{
using lattice::NodeId;

namespace
{
/// Weight of the belief that a record starts with, in observations.
constexpr double kBelief = 4.0;

/// With more steps out of a node than this it is costly to find where they lead.
constexpr std::uint32_t kFewSteps = 10;

/// Nothing is impossible.
constexpr double kLeast = 1e-3;
}  // namespace

LearningPredictor::LearningPredictor(lattice::Lattice& lattice) : lattice_(lattice), nearby_(lattice)
{
    for (std::size_t valid = 0; valid < kLevels; ++valid)
        for (std::size_t invalid = 0; invalid < kLevels; ++invalid)
        {
            const double belief = (static_cast<double>(valid) + 2.0) / (static_cast<double>(valid + invalid) + 2.1);
            records_[valid * kLevels + invalid] = {kBelief * belief, kBelief};
        }
}

std::size_t LearningPredictor::level(unsigned count)
{
    // Small numbers by themselves, larger ones by powers of two: neighbours number from two to hundreds.
    return std::min<std::size_t>(count <= 6 ? count : 4 + static_cast<std::size_t>(std::bit_width(count)), kLevels - 1);
}

std::size_t LearningPredictor::kindOf(const NearbyVerdicts::Counts& counts)
{
    return level(counts.valid) * kLevels + level(counts.invalid);
}

double LearningPredictor::probabilityValid(NodeId node) const
{
    const Record& record = records_[kindOf(nearby_.around(node))];
    return std::max(record.valid / record.all, kLeast);
}

double LearningPredictor::probabilityMotionValid() const
{
    return motions_.valid / motions_.all;
}

void LearningPredictor::learned(NodeId node, bool valid)
{
    Record& record = records_[kindOf(nearby_.around(node))];
    record.valid += valid ? 1.0 : 0.0;
    record.all += 1.0;
    if (!valid || lattice_.maxSteps() <= kFewSteps || lattice_.knowsNeighbours(node))
    {
        nearby_.add(node, valid);
        return;
    }
    if (untold_.size() <= node)
        untold_.resize(std::max<std::size_t>(lattice_.size(), 2 * untold_.size()));
    untold_[node] = true;
}

void LearningPredictor::left(NodeId node)
{
    if (node >= untold_.size() || !untold_[node])
        return;
    untold_[node] = false;
    nearby_.add(node, true);
}

void LearningPredictor::learnedMotion(bool valid)
{
    motions_.valid += valid ? 1.0 : 0.0;
    motions_.all += 1.0;
}
}  // namespace specplan::speculation
