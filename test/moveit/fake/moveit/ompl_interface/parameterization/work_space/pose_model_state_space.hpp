// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PoseSpace.h"

namespace ompl_interface
{
/// The look-alike under MoveIt's names.
class PoseModelStateSpace : public specplan::test::PoseSpace
{
public:
    using PoseSpace::PoseSpace;

    using StateType = PoseSpace::PoseState;

    bool computeStateFK(ompl::base::State* state) const
    {
        if ((state->as<PoseState>()->flags & PoseComputed) == 0)
            computePose(state);
        return true;
    }
};
}  // namespace ompl_interface
