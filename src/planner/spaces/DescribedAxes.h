// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/StateSpace.h>

#include "specplan/planner/LatticeAxes.h"
#include "specplan/planner/spaces/AxesComponent.h"

namespace specplan::planner
{
/// \throws std::invalid_argument with one line if a description cannot be right for any space.
void validate(const LatticeAxes& described);

/// Axes of a space that its user has described. \param origin a state of the space.
/// \param axes, access written; spacings are left open.
/// \throws ompl::Exception if the description does not fit the space.
void draftDescribed(const ompl::base::StateSpacePtr& space, const LatticeAxes& described,
                    const ompl::base::State* origin, std::vector<RealAxis>& axes, AxesComponent::Access& access);
}  // namespace specplan::planner
