// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: part of the planner's public face.
#pragma once

#include <condition_variable>
#include <mutex>

namespace specplan
{
namespace validity
{
class BudgetShare;
}

/// How many threads several planners may keep busy with checks, all of them together: for planners that solve at the
/// same time, as OMPL's ParallelPlan and MoveIt's planning attempts do. Given to each by
/// SpeculativeAStar::setThreadBudget.
///
/// A planner that solves always has one thread, that of its solve(). The others are lent for one check at a time, to
/// each of the planners that solve now the same number. So no more checks run at once than the budget has threads, or
/// than planners solve, if these are more. Which planner gets how many, and when, changes no result.
///
/// Threads: any.
class ThreadBudget
{
public:
    /// \param threads of all planners together; 0 stands for the number of processors.
    explicit ThreadBudget(unsigned threads = 0);
    ThreadBudget(const ThreadBudget&) = delete;
    ThreadBudget& operator=(const ThreadBudget&) = delete;

    /// At least 1.
    [[nodiscard]] unsigned threads() const noexcept
    {
        return threads_;
    }

private:
    friend class validity::BudgetShare;

    const unsigned threads_;
    std::mutex mutex_;
    std::condition_variable changed_;
    unsigned solving_ = 0;   ///< planners, each of which has one thread
    unsigned entering_ = 0;  ///< planners that wait for theirs
    unsigned lent_ = 0;      ///< threads beyond these
};
}  // namespace specplan
