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

    /// Seconds that the search's own work takes longer after each check in its thread than it would without: the check
    /// leaves its own data in the processor's caches, or lets the processor fall asleep.
    [[nodiscard]] double afterCheck() const noexcept
    {
        return afterCheck_;
    }

    void setAfterCheck(double seconds) noexcept
    {
        afterCheck_ = seconds;
    }

private:
    /// Coordinates of the state, or of both ends of the motion; one number more for a glance.
    using Key = std::vector<lattice::Coordinate>;

    struct Hash
    {
        [[nodiscard]] std::size_t operator()(const Key& key) const noexcept;
    };

    [[nodiscard]] static Key keyOf(const lattice::Lattice& lattice, lattice::CheckId check);

    std::unordered_map<Key, Entry, Hash> entries_;
    double afterCheck_ = 0.0;
};
}  // namespace specplan::planner
