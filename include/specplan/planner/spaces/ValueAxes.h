// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/StateSpace.h>

#include "specplan/planner/spaces/AxesComponent.h"

namespace specplan::planner
{
/// Axes of a space of an unknown class, through its value locations (StateSpace::copyToReals). Bounds and axes that
/// come round are found by moving one value at a time far out and looking where enforceBounds() puts it.
/// \param origin a state of the space. \param axes, access written; spacings are left open.
/// \throws ompl::Exception if the values do not make up the state, or one of them has no bounds.
void draftValues(const ompl::base::StateSpacePtr& space, const ompl::base::State* origin, std::vector<RealAxis>& axes,
                 AxesComponent::Access& access);
}  // namespace specplan::planner
