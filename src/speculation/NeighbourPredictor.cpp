// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/NeighbourPredictor.h"

#include <algorithm>
#include <bit>

namespace specplan::speculation
{
using lattice::NodeId;

namespace
{
/// Weight of the belief that a record starts with, in observations.
constexpr double kBelief = 4.0;
}  // namespace

NeighbourPredictor::NeighbourPredictor(lattice::Lattice& lattice) : lattice_(lattice)
{
    for (std::size_t valid = 0; valid < kLevels; ++valid)
        for (std::size_t invalid = 0; invalid < kLevels; ++invalid)
        {
            const double belief = (static_cast<double>(valid) + 2.0) / (static_cast<double>(valid + invalid) + 2.1);
            records_[valid * kLevels + invalid] = {kBelief * belief, kBelief};
        }
}

std::size_t NeighbourPredictor::level(unsigned count)
{
    // Each count up to four by itself, then by powers of two: neighbours number from two to hundreds.
    return std::min<std::size_t>(count <= 6 ? count : 4 + static_cast<std::size_t>(std::bit_width(count)) - 1,
                                 kLevels - 1);
}

std::size_t NeighbourPredictor::kindOf(const Around& around)
{
    return level(around.valid) * kLevels + level(around.invalid);
}

double NeighbourPredictor::probabilityValid(NodeId node) const
{
    const Record& record = records_[node < around_.size() ? kindOf(around_[node]) : 0];
    return std::max(record.valid / record.all, 1e-3);
}

double NeighbourPredictor::probabilityMotionValid() const
{
    return motions_.valid / motions_.all;
}

void NeighbourPredictor::learned(NodeId node, bool valid)
{
    if (around_.size() < lattice_.size())
        around_.resize(std::max(lattice_.size(), around_.size() * 2));
    Record& record = records_[kindOf(around_[node])];
    record.valid += valid ? 1.0 : 0.0;
    record.all += 1.0;
    lattice_.successors(node, neighbours_);
    if (around_.size() < lattice_.size())
        around_.resize(std::max(lattice_.size(), around_.size() * 2));
    for (const lattice::Successors::Edge& edge : neighbours_.edges)
        ++(valid ? around_[edge.node].valid : around_[edge.node].invalid);
}

void NeighbourPredictor::learnedMotion(bool valid)
{
    motions_.valid += valid ? 1.0 : 0.0;
    motions_.all += 1.0;
}
}  // namespace specplan::speculation
