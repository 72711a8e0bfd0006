// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "LazyBaseline.h"
#include "specplan/problems/GridSetup.h"
#include "specplan/search/LazySearch.h"
#include "specplan/validity/CheckStatistics.h"

namespace specplan::benchmarks
{
/// How long checks last.
enum class Durations
{
    Constant,      ///< 1
    Uniform,       ///< 0.5 to 1.5
    LogNormal,     ///< median 1, sigma 1: heavy tail
    CheapInvalid,  ///< valid states 1, invalid ones 0.1
};

/// One search over a grid through the core alone.
struct GridSearch
{
    const problems::GridProblem* problem;
    problems::GridCost cost = problems::GridCost::Length;
    bool cornerCutting = false;
    std::string policy = "runahead";     ///< none, direction (as published, with barrier), runahead
    std::string predictor = "learning";  ///< optimistic, nearby, learning
    unsigned workers = 32;
    double weight = 1.0;
    Durations durations = Durations::Constant;
};

struct Outcome
{
    validity::CheckStatistics counts;
    std::uint64_t expansions;
    std::uint64_t orderHash;
    double seconds;        ///< on the virtual clock, or real ones without checks' durations
    double searchSeconds;  ///< real time of the search itself, everything but checks
    double speedup;        ///< sum of the durations of all used checks / seconds
    double cost;           ///< of the path
};

/// Searches on the virtual clock with A*.
[[nodiscard]] Outcome searchVirtually(const GridSearch& search);

/// Searches on the virtual clock with the lazy search; policy and predictor mean nothing to it.
[[nodiscard]] Outcome searchLazily(const GridSearch& search, search::Selector selector);

/// Searches with a sequential lazy weighted A*, for comparison.
[[nodiscard]] BaselineResult searchBaseline(const GridSearch& search);
}  // namespace specplan::benchmarks
