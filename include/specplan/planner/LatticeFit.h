// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/SpaceInformation.h>

#include "specplan/planner/Embedding.h"

namespace specplan::planner
{
/// Finds out whether a lattice over the parts of a space fits how the space itself moves and measures, where its class
/// is not known to. Looks at the motions out of one node; checks nothing.
///
/// A lattice does not fit if
///  - motions are curves that leave the cells that they should cross (aircraft, cars in wind);
///  - no step of some part alone has a finite length (time and place, tied by a greatest speed);
///  - the space is glued together in a way that its values do not tell (Klein's bottle).
///
/// \param origin a state that the lattice goes through.
/// \throws ompl::Exception that names the space and the reason, if the lattice does not fit.
void requireFit(const ompl::base::SpaceInformation& si, const Embedding& embedding, const ompl::base::State* origin);
}  // namespace specplan::planner
