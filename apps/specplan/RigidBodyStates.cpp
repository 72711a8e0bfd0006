// SPDX-License-Identifier: BSD-3-Clause
#include "RigidBodyStates.h"

#include <ompl/base/goals/GoalState.h>

#include "specplan/problems/fcl/RigidBodyChecker.h"

namespace specplan::command
{
namespace ob = ompl::base;
using Eigen::Vector3d;

RigidBodyStates::RigidBodyStates(const problems::RigidBodySetup& setup, const Run& run) : setup_(setup), run_(run)
{
}

Eigen::AlignedBox3d RigidBodyStates::space() const
{
    const ob::RealVectorBounds& bounds = setup_.bounds();
    Eigen::AlignedBox3d space = boundsOf(setup_.world());
    for (unsigned i = 0; i < bounds.low.size(); ++i)
    {
        space.min()[i] = bounds.low[i];
        space.max()[i] = bounds.high[i];
    }
    return space;
}

Vector3d RigidBodyStates::placeOf(const std::vector<double>& state) const
{
    return {state[0], state[1], setup_.problem().planar ? 0.0 : state[2]};
}

Eigen::Isometry3d RigidBodyStates::poseOf(const ob::State* state) const
{
    return problems::posesOf(*run_.setup->getStateSpace(), state).front();
}

Eigen::Isometry3d RigidBodyStates::start() const
{
    return poseOf(run_.setup->getProblemDefinition()->getStartState(0));
}

Eigen::Isometry3d RigidBodyStates::goal() const
{
    return poseOf(run_.setup->getGoal()->as<ob::GoalState>()->getState());
}

std::vector<Vector3d> RigidBodyStates::checkedAndUnused() const
{
    std::vector<Vector3d> places;
    if (!run_.planner)
        return places;
    std::vector<double> numbers;
    run_.planner->visitStates(
        [&](const ob::State* state, SpeculativeAStar::StateFate fate)
        {
            if (fate != SpeculativeAStar::StateFate::CheckedUnused)
                return;
            run_.setup->getStateSpace()->copyToReals(numbers, state);
            places.push_back(placeOf(numbers));
        });
    return places;
}
}  // namespace specplan::command
