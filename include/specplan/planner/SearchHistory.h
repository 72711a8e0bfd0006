// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "specplan/planner/SearchReport.h"

namespace specplan::planner
{
/// Keeps what became of each search of a query.
///
/// Threads: search thread.
class SearchHistory
{
public:
    void clear() noexcept
    {
        searches_.clear();
    }

    /// A search begins. \param level of the lattice, see Embedding. \param checksUsed by the query so far.
    void begin(int level, double weight, double states, std::uint64_t checksUsed)
    {
        searches_.push_back({std::ldexp(1.0, -level), weight, "stopped", 0, 0, states});
        usedBefore_ = checksUsed;
    }

    /// How far the current search has come. \param end see LatticeSearchReport.
    void note(const char* end, std::uint64_t expansions, std::uint64_t checksUsed)
    {
        LatticeSearchReport& search = searches_.back();
        search.end = end;
        search.expansions = expansions;
        search.checksUsed = checksUsed - usedBefore_;
    }

    [[nodiscard]] const std::vector<LatticeSearchReport>& searches() const noexcept
    {
        return searches_;
    }

private:
    std::vector<LatticeSearchReport> searches_;
    std::uint64_t usedBefore_ = 0;
};
}  // namespace specplan::planner
