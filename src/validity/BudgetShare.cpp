// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/BudgetShare.h"

#include <algorithm>
#include <utility>

namespace specplan::validity
{
BudgetShare::BudgetShare(std::shared_ptr<ThreadBudget> budget) : budget_(std::move(budget))
{
}

void BudgetShare::enter()
{
    ThreadBudget& all = *budget_;
    std::unique_lock lock(all.mutex_);
    ++all.entering_;  // nobody borrows meanwhile
    all.changed_.wait(lock, [&all] { return all.solving_ + all.lent_ < all.threads_ || all.solving_ >= all.threads_; });
    --all.entering_;
    ++all.solving_;
    lock.unlock();
    all.changed_.notify_all();
}

void BudgetShare::leave()
{
    {
        const std::lock_guard lock(budget_->mutex_);
        --budget_->solving_;
    }
    budget_->changed_.notify_all();
}

/// Rounded up, so that none is left over; who comes first has one more.
unsigned BudgetShare::fairPart() const noexcept
{
    const ThreadBudget& all = *budget_;
    const unsigned planners = std::max(all.solving_ + all.entering_, 1U);
    const unsigned left = all.threads_ - std::min(all.threads_, planners);
    return (left + planners - 1) / planners;
}

unsigned BudgetShare::limit() const
{
    const std::lock_guard lock(budget_->mutex_);
    return fairPart();
}

bool BudgetShare::borrow(const std::function<bool()>& gaveUp)
{
    ThreadBudget& all = *budget_;
    std::unique_lock lock(all.mutex_);
    const auto isThere = [&]
    { return all.entering_ == 0 && all.solving_ + all.lent_ < all.threads_ && lent_ < fairPart(); };
    bool isWanted = true;
    all.changed_.wait(lock,
                      [&]
                      {
                          isWanted = !gaveUp();
                          return !isWanted || isThere();
                      });
    if (!isWanted)
        return false;
    ++lent_;
    ++all.lent_;
    return true;
}

void BudgetShare::giveBack()
{
    {
        const std::lock_guard lock(budget_->mutex_);
        --lent_;
        --budget_->lent_;
    }
    budget_->changed_.notify_all();
}

void BudgetShare::wake()
{
    {
        const std::lock_guard lock(budget_->mutex_);  // who is about to wait has asked before this
    }
    budget_->changed_.notify_all();
}
}  // namespace specplan::validity
