// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: part of the planner's public face.
#pragma once

#include <cstdint>

#include <ompl/base/SpaceInformation.h>

#include "specplan/planner/BuiltWithOmpl.h"
#include "specplan/planner/CheckerReport.h"
#include "specplan/planner/SpeculativeAStar.h"

namespace specplan
{
/// How much testChecker() does.
struct CheckerTestOptions
{
    unsigned samples = 1000;  ///< states to check, 1 or more
    unsigned threads = 8;     ///< that call at once, 1 to 4096
    unsigned rounds = 3;      ///< calls for each state and thread, 1 or more
    double timeLimit = 60.0;  ///< seconds; the test ends within one call of it
    double patience = 10.0;   ///< seconds without an answer after which a warning names the state
    std::uint32_t seed =
        1;  ///< of lattice states and of the order of calls; uniform samples follow ompl::RNG::setSeed()
};

/// Tries whether a state validity checker may be called from several threads, and whether it keeps OMPL's contract:
/// equal answers for equal states, no writes into the state, no exceptions.
///
/// The states are those that the planner would check: inside the bounds, half of them sampled uniformly, half of them
/// states of the planner's own lattice. Each call gets a fresh copy. One thread checks all of them `rounds` times,
/// then `threads` threads check all of them at once, `rounds` times each.
///
/// \param allocator as in SpeculativeAStar::setStateValidityCheckerAllocator: each thread then uses the checker of
/// its own. Without one all threads use the checker of the space information, which is set up if it is not yet.
/// \throws ompl::Exception if there is no checker, or no state inside the bounds was found;
/// std::invalid_argument if an option is out of range. Exceptions of the checker are findings.
///
/// A clean report is no proof: a race that is rare may not show. ThreadSanitizer sees more.
///
/// Threads: one test at a time for one checker; the calling thread is one of those that check.
[[nodiscard]] CheckerReport testChecker(const ompl::base::SpaceInformationPtr& si,
                                        const CheckerTestOptions& options = {},
                                        const SpeculativeAStar::StateValidityCheckerAllocator& allocator = {});
}  // namespace specplan
