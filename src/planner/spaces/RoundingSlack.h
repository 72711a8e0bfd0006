// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace specplan::planner
{
/// This much of a step, of an axis or of a grid of rotations is rounding: what lies so close to bounds or to a grid
/// line lies on them.
inline constexpr double kRoundingSlack = 1e-9;
}  // namespace specplan::planner
