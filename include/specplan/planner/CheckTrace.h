// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "specplan/lattice/Lattice.h"

namespace specplan::planner
{
/// What checks found and how long that took, so that the same search can be run again without them.
///
/// Nodes and motions get other numbers in every run: checks go by their coordinates here.
///
/// Threads: one at a time.
class CheckTrace
{
public:
    struct Entry
    {
        double seconds = 0.0;
        double cost = std::numeric_limits<double>::quiet_NaN();  ///< of a valid motion, where an objective tells it
        bool valid = false;
    };

    /// What is known of a check; nullptr if nothing is.
    [[nodiscard]] const Entry* find(const lattice::Lattice& lattice, lattice::CheckId check) const;

    /// Of a check that is known already the first entry stays.
    void add(const lattice::Lattice& lattice, lattice::CheckId check, const Entry& entry);

    [[nodiscard]] std::size_t size() const noexcept
    {
        return entries_.size();
    }

    /// Seconds of the search's own work for each second that it takes in a run without checks. Between checks, which
    /// leave their own data in the processor's caches, the same work takes longer.
    [[nodiscard]] double pace() const noexcept
    {
        return pace_;
    }

    void setPace(double pace) noexcept
    {
        pace_ = pace;
    }

private:
    /// Coordinates of the state, or of both ends of the motion.
    using Key = std::vector<lattice::Coordinate>;

    struct Hash
    {
        [[nodiscard]] std::size_t operator()(const Key& key) const noexcept;
    };

    [[nodiscard]] static Key keyOf(const lattice::Lattice& lattice, lattice::CheckId check);

    std::unordered_map<Key, Entry, Hash> entries_;
    double pace_ = 1.0;
};
}  // namespace specplan::planner
