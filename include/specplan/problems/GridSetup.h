// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/BuiltWithOmpl.h"
#include "specplan/planner/PlannerSettings.h"
#include "specplan/problems/ArtificialCheck.h"
#include "specplan/problems/GridMap.h"

namespace specplan::problems
{
/// What a move costs.
enum class GridCost
{
    Length,  ///< octile path length
    Steps,   ///< 1 a move, with the number of moves on an empty map as heuristic
    Seed     ///< 1 a move, with the straight distance as heuristic as in the paper's program; not admissible
};

/// Makes an OMPL problem of a grid: the state (x, y) is the middle of that cell, the plane is as large as the map, a
/// state is valid if its cell is free. The validity resolution is coarser than a step, so a step needs no check besides
/// its end. \throws InputError if start or goal is blocked or off the map; `name` is the file to blame.
[[nodiscard]] std::shared_ptr<ompl::geometric::SimpleSetup> makeGridSetup(const GridProblem& problem,
                                                                          const std::string& name, GridCost cost,
                                                                          ArtificialCheck check);

/// Planner settings for such a set-up: one lattice node a cell, eight neighbours.
[[nodiscard]] PlannerSettings gridPlannerSettings(bool cornerCutting);

/// The cell of a state.
[[nodiscard]] GridCell cellOf(const ompl::base::State* state);
}  // namespace specplan::problems
