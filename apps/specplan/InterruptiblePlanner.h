// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include <ompl/base/Planner.h>

#include "Convergence.h"
#include "CountingChecker.h"

namespace specplan::command
{
/// Another planner under its own name and parameters, for OMPL's Benchmark: it stops when the user interrupts the
/// program, state checks and falling costs of each run are recorded, and what it throws is something that Benchmark
/// catches.
///
/// Threads: as the other planner.
class InterruptiblePlanner : public ompl::base::Planner
{
public:
    /// \param checker the one that `planner` calls.
    InterruptiblePlanner(ompl::base::PlannerPtr planner, std::shared_ptr<const CountingChecker> checker);

    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
    using ompl::base::Planner::solve;

    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr& pdef) override;
    void clear() override;
    void clearQuery() override;
    void setup() override;
    void checkValidity() override;
    void getPlannerData(ompl::base::PlannerData& data) const override;
    void printProperties(std::ostream& out) const override;
    void printSettings(std::ostream& out) const override;

    [[nodiscard]] const ompl::base::Planner& inner() const noexcept
    {
        return *planner_;
    }

    /// How the cost fell during the last solve().
    [[nodiscard]] const Convergence& convergence() const noexcept
    {
        return convergence_;
    }

    /// State checks of the last solve().
    [[nodiscard]] std::uint64_t checks() const noexcept
    {
        return checks_;
    }

private:
    ompl::base::PlannerPtr planner_;
    std::shared_ptr<const CountingChecker> checker_;
    std::uint64_t checks_ = 0;
    Convergence convergence_;
};
}  // namespace specplan::command
