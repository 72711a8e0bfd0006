// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include <ompl/base/SpaceInformation.h>

#include "specplan/planner/CheckTrace.h"
#include "specplan/planner/OmplChecker.h"
#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/planner/TracingChecker.h"
#include "specplan/validity/BudgetShare.h"
#include "specplan/validity/Executor.h"

namespace specplan::planner
{
/// Who runs the checks, and with which of the user's checkers and motion validators. Lives as long as the planner;
/// threads are kept from one query to the next.
///
/// Threads: search thread.
class Workers
{
public:
    explicit Workers(ompl::base::SpaceInformationPtr si);

    /// Makes executor and checker, unless those there are fit the settings.
    void prepare(const PlannerSettings& settings);

    /// What this planner has of the budget; empty without one. The same until another budget is given.
    [[nodiscard]] std::shared_ptr<validity::BudgetShare> openShare();

    /// Checkers and motion validators for each worker. `prepare` comes first.
    /// \throws ompl::Exception if an allocator returns nothing.
    [[nodiscard]] OmplChecker::Sources makeSources() const;

    /// After `prepare`.
    [[nodiscard]] validity::Executor& executor() const noexcept
    {
        return *executor_;
    }

    /// After `prepare`.
    [[nodiscard]] OmplChecker& checker() const noexcept
    {
        return *checker_;
    }

    /// Stands before the checker, if there is a trace; nullptr otherwise.
    [[nodiscard]] TracingChecker* tracer() const noexcept
    {
        return tracer_.get();
    }

    /// Processors that there are for this process.
    [[nodiscard]] unsigned processors() const noexcept
    {
        return processors_;
    }

    // What the user has given; takes effect with the next `prepare` and `makeSources`. Empty for none.
    SpeculativeAStar::StateValidityCheckerAllocator checkerAllocator;
    SpeculativeAStar::MotionValidatorAllocator motionValidatorAllocator;
    std::shared_ptr<ThreadBudget> budget;  ///< shared with other planners
    std::shared_ptr<CheckTrace> trace;     ///< of what checks find and how long they take

private:
    /// What an executor is made of.
    struct Make
    {
        unsigned threads = 0;
        std::string executor;
        double virtualCheckCost = 0.0;
        std::shared_ptr<CheckTrace> trace;
        std::shared_ptr<validity::BudgetShare> share;

        bool operator==(const Make&) const = default;
    };

    const ompl::base::SpaceInformationPtr si_;
    const unsigned processors_;
    std::shared_ptr<validity::BudgetShare> share_;
    Make made_;
    // Order matters: the executor's threads end before the checker they use.
    std::unique_ptr<OmplChecker> checker_;
    std::unique_ptr<TracingChecker> tracer_;
    std::unique_ptr<validity::Executor> executor_;
};
}  // namespace specplan::planner
