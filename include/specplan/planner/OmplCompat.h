// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/PlannerStatus.h>
#include <ompl/config.h>

namespace specplan::planner
{
/// "No solution exists on this lattice". OMPL has a status for it from 1.6 on; before, ABORT comes closest.
#if OMPL_VERSION_VALUE >= 1006000
inline constexpr ompl::base::PlannerStatus::StatusType kInfeasible = ompl::base::PlannerStatus::INFEASIBLE;
#else
inline constexpr ompl::base::PlannerStatus::StatusType kInfeasible = ompl::base::PlannerStatus::ABORT;
#endif
}  // namespace specplan::planner
