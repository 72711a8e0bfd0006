// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

#include <ompl/base/StateValidityChecker.h>

namespace specplan::command
{
/// Counts the calls of another checker, which may come from any number of threads.
class CountingChecker : public ompl::base::StateValidityChecker
{
public:
    CountingChecker(const ompl::base::SpaceInformationPtr& si, ompl::base::StateValidityCheckerPtr checker)
        : ompl::base::StateValidityChecker(si), checker_(std::move(checker))
    {
        specs_ = checker_->getSpecs();
    }

    bool isValid(const ompl::base::State* state) const override
    {
        ++calls_;
        return checker_->isValid(state);
    }

    double clearance(const ompl::base::State* state) const override
    {
        return checker_->clearance(state);
    }

    [[nodiscard]] std::uint64_t calls() const noexcept
    {
        return calls_;
    }

private:
    ompl::base::StateValidityCheckerPtr checker_;
    mutable std::atomic<std::uint64_t> calls_ = 0;
};
}  // namespace specplan::command
