// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <ompl/base/StateSpace.h>

#include "specplan/planner/LatticeAxes.h"

namespace specplan::planner
{
/// What a user has said about state spaces of their own.
struct SpaceHooks
{
    std::vector<LatticeAxes> described;                      ///< one for each space
    std::function<void(ompl::base::State* state)> complete;  ///< fills in what values do not tell; empty for none

    /// The description of a space; nullptr if there is none. \param whole whether it is not part of another one.
    [[nodiscard]] const LatticeAxes* axesOf(const ompl::base::StateSpace& space, bool whole) const
    {
        for (const LatticeAxes& axes : described)
            if (axes.space.empty() ? whole : axes.space == space.getName())
                return &axes;
        return nullptr;
    }
};
}  // namespace specplan::planner
