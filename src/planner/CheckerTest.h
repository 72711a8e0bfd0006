// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "AnswerWatch.h"
#include "CheckerTally.h"
#include "specplan/planner/StateHandle.h"
#include "specplan/planner/TestChecker.h"

namespace specplan::planner
{
/// One run of testChecker().
class CheckerTest
{
public:
    CheckerTest(ompl::base::SpaceInformationPtr si, const CheckerTestOptions& options,
                const SpeculativeAStar::StateValidityCheckerAllocator& allocator);

    [[nodiscard]] CheckerReport run();

private:
    using Kind = CheckerReport::Kind;

    void makeCheckers(const SpeculativeAStar::StateValidityCheckerAllocator& allocator);
    void runSerially();
    void runOneByOne();
    void runThreads();
    void runRounds(unsigned thread, CheckerTally& tally);
    void call(std::size_t state, unsigned worker, CheckerTally& tally);
    [[nodiscard]] bool isPast(double share) const;
    [[nodiscard]] std::vector<std::size_t> order(unsigned round, unsigned thread) const;

    void judge();
    void judgeOneThread();
    void judgeThreads();
    [[nodiscard]] bool wavers(std::size_t state);
    void judgeExceptions();
    void judgeWrites();
    void judgeTimes();
    void find(Kind kind, std::string text);
    [[nodiscard]] std::string at(std::size_t state) const;

    ompl::base::SpaceInformationPtr si_;
    CheckerTestOptions options_;
    double start_;
    std::vector<StateHandle> states_;
    std::vector<ompl::base::StateValidityCheckerPtr> checkers_;  ///< one for each thread, or one for all
    AnswerWatch watch_;
    std::size_t tried_ = 0;   ///< states that were checked before the time was up: the first ones
    CheckerTally oneThread_;  ///< one thread, one checker
    CheckerTally oneByOne_;   ///< one thread, all checkers in turn
    CheckerTally threads_;    ///< all threads
    CheckerReport report_;
};
}  // namespace specplan::planner
