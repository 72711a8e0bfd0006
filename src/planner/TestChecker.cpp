// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/TestChecker.h"

#include <cmath>
#include <stdexcept>

#include <ompl/util/Exception.h>

#include "CheckerTest.h"

namespace specplan
{
namespace
{
void require(bool holds, const char* expected)
{
    if (!holds)
        throw std::invalid_argument(std::string("testChecker: ") + expected);
}
}  // namespace

CheckerReport testChecker(const ompl::base::SpaceInformationPtr& si, const CheckerTestOptions& options,
                          const SpeculativeAStar::StateValidityCheckerAllocator& allocator)
{
    require(si != nullptr, "expected a space information, found none");
    require(options.samples >= 1, "samples must be 1 or more");
    require(options.threads >= 1 && options.threads <= 4096, "threads must be between 1 and 4096");
    require(options.rounds >= 1, "rounds must be 1 or more");
    require(options.timeLimit > 0.0 && std::isfinite(options.timeLimit), "timeLimit must be seconds greater than 0");
    require(options.patience > 0.0 && std::isfinite(options.patience), "patience must be seconds greater than 0");
    if (!allocator && !si->getStateValidityChecker())
        throw ompl::Exception("testChecker: the space information has no state validity checker");
    if (!si->isSetup())
        si->setup();
    return planner::CheckerTest(si, options, allocator).run();
}
}  // namespace specplan
