// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "FaultyProblem.h"

namespace specplan::test
{
/// Planners that are made, used and destroyed by several threads at once, each with one at a time: by turns with 1, 2
/// and 4 workers, eager and lazy; some are stopped on the way, some never used.
class ManyPlanners
{
public:
    ManyPlanners()
    {
        for (const char* evaluation : {"eager", "lazy"})
        {
            FaultyProblem problem(Place::Checker, Fault::None, 0, 0);
            problem.makePlanner(1, evaluation);
            EXPECT_EQ(problem.solve(), ob::PlannerStatus::EXACT_SOLUTION);
            hashes_.push_back(problem.planner->getReport().orderHash);
        }
    }

    /// \return checks run.
    std::uint64_t run(unsigned planners, unsigned atOnce)
    {
        checks_ = 0;
        std::atomic<unsigned> next{0};
        std::vector<std::thread> threads;
        for (unsigned thread = 0; thread < atOnce; ++thread)
            threads.emplace_back(
                [&]
                {
                    for (unsigned number = next++; number < planners; number = next++)
                        useOne(number);
                });
        for (std::thread& thread : threads)
            thread.join();
        return checks_;
    }

private:
    void useOne(unsigned number)
    {
        const bool lazy = number % 2 == 1;
        FaultyProblem problem(Place::Checker, Fault::None, 0, 0);
        problem.makePlanner(1U << (number % 3), lazy ? "lazy" : "eager");
        if (number % 7 == 0)
            return;  // never used
        if (number % 5 == 0)
        {
            unsigned asked = 0;
            (void)problem.planner->solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 30; }));
        }
        if (number % 11 == 0)
            return;  // left on the way
        EXPECT_EQ(problem.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(problem.planner->getReport().orderHash, hashes_[lazy ? 1 : 0]);
        checks_ += problem.planner->getReport().checksTotal;
    }

    std::vector<std::uint64_t> hashes_;
    std::atomic<std::uint64_t> checks_{0};
};
}  // namespace specplan::test
