// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/spaces/Component.h"
#include "specplan/planner/spaces/Decomposition.h"

namespace specplan::planner
{
/// Up to so many axes a lattice is small enough to be searched through.
inline constexpr unsigned kFewAxes = 4;

/// The lattices over the parts of a space, and what is common to them.
struct Components
{
    std::vector<std::unique_ptr<Component>> all;  ///< one for each part
    unsigned axes = 0;                            ///< degrees of freedom; a rotation in space has three
    unsigned connectivity = 0;                    ///< axes that steps of several components may change together
    std::vector<bool> begunCoarse;                ///< of each: whether it has twice the usual spacing at first
};

/// Makes the components, with a lattice that goes through `origin`.
///
/// Without a resolution the space gets about 60000 nodes, and at most 101 steps along an axis; at least 20 up to four
/// axes, 12 up to seven, and 8 beyond; angles beside other axes get 16, and rotations the 40 that are 90 degrees apart.
/// The places of SE2 and SE3 get as many in all, equally far apart along all axes. That lattice can be refined; one
/// that was asked for cannot.
///
/// \param coarse whether all but rotations and cars, and but angles beside many other axes, get twice that spacing,
/// where none was asked for.
///
/// \throws ompl::Exception where an axis has no bounds, or the settings do not fit the space.
[[nodiscard]] Components makeComponents(const Decomposition& decomposition, const PlannerSettings& settings,
                                        const ompl::base::State* origin, bool coarse);
}  // namespace specplan::planner
