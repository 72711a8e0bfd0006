// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

namespace specplan::planner
{
/// Distance of two states as the space measures it. \throws ompl::Exception if that is NaN, which no search can order.
inline double distance(const ompl::base::SpaceInformation& si, const ompl::base::State* from,
                       const ompl::base::State* to)
{
    const double distance = si.distance(from, to);
    if (std::isnan(distance))
        throw ompl::Exception("the state space '" + si.getStateSpace()->getName() +
                              "' has two states whose distance is NaN");
    return distance;
}
}  // namespace specplan::planner
