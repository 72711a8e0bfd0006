// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "specplan/planner/StateHandle.h"

namespace specplan::planner
{
/// States to try a checker with: inside the bounds, half of them sampled uniformly, half of them from walks on the
/// lattice that the planner would search. All are sampled where the space has no lattice. No checker has seen them.
/// \throws ompl::Exception if samples do not lie inside the bounds.
[[nodiscard]] std::vector<StateHandle> makeTestStates(const ompl::base::SpaceInformation& si, std::size_t count,
                                                      std::uint32_t seed);

/// The values of a state in one line, "(0.1, 0.25)".
[[nodiscard]] std::string describeState(const ompl::base::SpaceInformation& si, const ompl::base::State* state);
}  // namespace specplan::planner
