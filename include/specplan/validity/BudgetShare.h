// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "specplan/validity/ThreadBudget.h"

namespace specplan::validity
{
/// What one planner has of a budget of threads.
///
/// Threads: `enter` and `leave` by the search thread; the rest by any.
class BudgetShare
{
public:
    /// \param budget there has to be one.
    explicit BudgetShare(std::shared_ptr<ThreadBudget> budget);

    /// Takes the thread that a planner has while it solves. Waits for a check of other planners to end where these have
    /// all threads; not where there are more planners than threads.
    void enter();
    void leave();

    /// Threads that the planner may borrow now beyond its own: a fair part of what there is. A hint.
    [[nodiscard]] unsigned limit() const;

    /// Borrows a thread for one check; waits for one. \param gaveUp whether it is no longer wanted; asked under a lock.
    /// \return false if it was no longer wanted.
    [[nodiscard]] bool borrow(const std::function<bool()>& gaveUp);
    void giveBack();

    /// Makes those who wait ask whether they gave up.
    void wake();

    [[nodiscard]] const std::shared_ptr<ThreadBudget>& budget() const noexcept
    {
        return budget_;
    }

private:
    [[nodiscard]] unsigned fairPart() const noexcept;

    const std::shared_ptr<ThreadBudget> budget_;
    unsigned lent_ = 0;  ///< to this planner; guarded by the budget's mutex
};

/// A planner's own thread while it solves.
class BudgetSeat
{
public:
    /// \param share nullptr for a planner that shares nothing.
    explicit BudgetSeat(std::shared_ptr<BudgetShare> share) : share_(std::move(share))
    {
        if (share_)
            share_->enter();
    }

    ~BudgetSeat()
    {
        if (share_)
            share_->leave();
    }

    BudgetSeat(const BudgetSeat&) = delete;
    BudgetSeat& operator=(const BudgetSeat&) = delete;

private:
    const std::shared_ptr<BudgetShare> share_;
};
}  // namespace specplan::validity
