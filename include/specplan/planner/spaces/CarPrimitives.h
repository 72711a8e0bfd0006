// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <ompl/base/StateSpace.h>

#include "specplan/lattice/NodeTable.h"

namespace specplan::planner
{
/// A motion of a car on a lattice of places and headings, from the place (0, 0).
struct CarMotion
{
    lattice::Coordinate from;  ///< heading, 0 to headings - 1
    lattice::Coordinate dx;
    lattice::Coordinate dy;
    lattice::Coordinate to;  ///< heading at the end
    double length = 0.0;
};

/// Chooses the motions that a lattice is made of: those that are no loops, and that no two shorter ones replace.
/// \param headings a multiple of 4. \param reach steps that a motion may lead away. \param step length of one.
/// \param loop a motion longer than this many times its straight distance is a loop. \param length of a motion by its
/// ends; asked for a quarter of all headings, the rest is turned.
/// \return motions sorted by length.
[[nodiscard]] std::vector<CarMotion> carPrimitives(lattice::Coordinate headings, lattice::Coordinate reach, double step,
                                                   double loop, const std::function<double(const CarMotion&)>& length);

/// Turning radius of a Dubins or Reeds-Shepp space: OMPL does not tell, but lengths are proportional to it.
[[nodiscard]] double turningRadius(const ompl::base::StateSpace& space);
}  // namespace specplan::planner
