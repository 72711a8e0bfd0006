// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: part of the planner's public face.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace specplan
{
/// One search of a query: a lattice and a weight.
struct LatticeSearchReport
{
    double spacing = 1.0;          ///< as a multiple of the lattice's usual spacing: 2 is coarser, 0.5 finer
    double weight = 1.0;           ///< of the heuristic
    std::string end;               ///< "solved", "no path", "given up" for another lattice, or "stopped"
    std::uint64_t expansions = 0;  ///< in this search
    std::uint64_t checksUsed = 0;  ///< verdicts that this search was the first to need
    double states = 0.0;           ///< lattice states inside the bounds, about
};

/// What the last solve() did, and what it cost. Counts and times add up over the calls of solve() that continue one
/// query.
struct SearchReport
{
    /// "not started", "solved", "infeasible", "timeout", "invalid start", "invalid goal", "unrecognized goal", "crash".
    std::string status = "not started";
    std::string error;  ///< what the failing check said, if status is "crash"

    std::string evaluation = "eager";  ///< what was done: `lazy` is not possible for every objective and goal

    double cost = 0.0;             ///< of the solution; NaN without one
    double weight = 1.0;           ///< of the heuristic in the last search
    double bound = 0.0;            ///< the cost is at most this many times the optimum of the lattice; NaN without one
    unsigned refinements = 0;      ///< how often the lattice's spacing was halved
    std::uint64_t expansions = 0;  ///< the goal's own included
    std::uint64_t checksUsed = 0;  ///< different checks whose verdict the search needed
    std::uint64_t checksReused = 0;         ///< different checks whose verdict was known from an earlier query
    std::uint64_t checksTotal = 0;          ///< checks run
    std::uint64_t demandedChecks = 0;       ///< of these, run because the search asked
    std::uint64_t speculativeChecks = 0;    ///< handed out ahead of demand
    std::uint64_t speculativeUsed = 0;      ///< of these, used later
    std::uint64_t speculativeDropped = 0;   ///< of these, taken back before they started
    std::uint64_t speculativeFailures = 0;  ///< checks that threw and were not needed
    std::uint64_t pathChecks = 0;           ///< of found paths once more (own classes of spaces); in no other count
    std::uint64_t usedReady = 0;            ///< used verdicts that were there when first asked for
    std::uint64_t usedAfterWait = 0;        ///< used verdicts that the search waited for
    std::uint64_t usedInline = 0;           ///< used verdicts from checks in the search thread
    double accuracy = 1.0;                  ///< speculative checks used / run
    double coverage = 0.0;                  ///< used verdicts that came from speculation / all used verdicts
    double timeliness = 1.0;                ///< speculative verdicts ready when first demanded / used

    double wallTime = 0.0;     ///< seconds in solve()
    double searchTime = 0.0;   ///< seconds of the search's own work
    double waitTime = 0.0;     ///< seconds in which the search stood still for checks
    double virtualTime = 0.0;  ///< seconds on the virtual clock; 0 with real threads
    double sequentialTime =
        0.0;               ///< seconds that sequential A* takes: its checks one after the other, plus the search's work
    double speedup = 1.0;  ///< sequentialTime / time taken, on the clock of the executor
    double efficiency = 1.0;  ///< speedup / threads

    unsigned threads = 1;         ///< how many checks could run at once
    std::uint64_t orderHash = 0;  ///< hash of the sequence of expansions: equal for equal sequences
    std::uint64_t nodes = 0;      ///< lattice nodes touched

    /// The searches of this query in order; the last one may be unfinished.
    std::vector<LatticeSearchReport> searches;
    double distanceToGoal = 0.0;  ///< of the nearest state reached, where the end was a time-out; NaN if not known
    std::string advice;           ///< what to try next, where no path was found; may be several sentences
};
}  // namespace specplan
