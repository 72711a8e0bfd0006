// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>

namespace specplan::planner
{
/// What a query was built for. Weak, so that a planner keeps no checker alive; the control block stays, so a new object
/// at the old address is told apart.
class Origins
{
public:
    Origins() = default;
    Origins(const ompl::base::SpaceInformation& si, const ompl::base::ProblemDefinition& pdef);

    /// Whether a query that was built for the one serves the other. All path lengths are the same objective.
    [[nodiscard]] bool same(const Origins& other) const;

private:
    std::weak_ptr<const void> checker_;
    std::weak_ptr<const void> motionValidator_;
    std::weak_ptr<const void> objective_;
    std::vector<double> space_;  ///< bounds, weights and validity resolution
};
}  // namespace specplan::planner
