// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/GridSetup.h"

#include <algorithm>
#include <cmath>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace ob = ompl::base;

namespace
{
const double* valuesOf(const ob::State* state)
{
    return state->as<ob::RealVectorStateSpace::StateType>()->values;
}

/// Free cell or not, after an artificial while. Reads the map only, so any number of threads may ask.
class GridValidityChecker : public ob::StateValidityChecker
{
public:
    GridValidityChecker(const ob::SpaceInformationPtr& si, GridMap map, ArtificialCheck check)
        : ob::StateValidityChecker(si), map_(std::move(map)), check_(check)
    {
    }

    bool isValid(const ob::State* state) const override
    {
        pass(check_);
        const GridCell cell = cellOf(state);
        return map_.isFree(cell[0], cell[1]);
    }

private:
    GridMap map_;
    ArtificialCheck check_;
};

/// 1 a move; the heuristic is the caller's choice.
class MoveCountObjective : public ob::OptimizationObjective
{
public:
    MoveCountObjective(const ob::SpaceInformationPtr& si, bool straightHeuristic)
        : ob::OptimizationObjective(si), straightHeuristic_(straightHeuristic)
    {
        description_ = "number of moves";
    }

    ob::Cost stateCost(const ob::State*) const override
    {
        return identityCost();
    }

    ob::Cost motionCost(const ob::State*, const ob::State*) const override
    {
        return ob::Cost(1.0);
    }

    ob::Cost motionCostHeuristic(const ob::State* from, const ob::State* to) const override
    {
        const double dx = std::abs(valuesOf(from)[0] - valuesOf(to)[0]);
        const double dy = std::abs(valuesOf(from)[1] - valuesOf(to)[1]);
        return ob::Cost(straightHeuristic_ ? std::hypot(dx, dy) : std::max(dx, dy));
    }

private:
    bool straightHeuristic_;
};

void requireFree(const GridMap& map, const GridCell& cell, const std::string& name, const std::string& what)
{
    const std::string place = concat(what, " ", cell[0], ",", cell[1]);
    if (!map.contains(cell[0], cell[1]))
        throw InputError(name, 0,
                         concat("expected a ", what, " inside the map of ", map.width(), " x ", map.height(),
                                " cells, found ", place));
    if (!map.isFree(cell[0], cell[1]))
        throw InputError(name, 0, concat("expected a free ", what, " cell, but ", place, " is an obstacle"));
}

ob::OptimizationObjectivePtr makeObjective(const ob::SpaceInformationPtr& si, GridCost cost)
{
    if (cost == GridCost::Length)
        return std::make_shared<ob::PathLengthOptimizationObjective>(si);
    return std::make_shared<MoveCountObjective>(si, cost == GridCost::Seed);
}
}  // namespace

GridCell cellOf(const ob::State* state)
{
    return {static_cast<int>(std::lround(valuesOf(state)[0])), static_cast<int>(std::lround(valuesOf(state)[1]))};
}

std::shared_ptr<ompl::geometric::SimpleSetup> makeGridSetup(const GridProblem& problem, const std::string& name,
                                                            GridCost cost, ArtificialCheck check)
{
    requireFree(problem.map, problem.start, name, "start");
    requireFree(problem.map, problem.goal, name, "goal");
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    ob::RealVectorBounds bounds(2);
    bounds.low = {-0.5, -0.5};
    bounds.high = {problem.map.width() - 0.5, problem.map.height() - 0.5};
    space->setBounds(bounds);
    // Longer than a diagonal step: motions along the lattice have no inner states.
    space->setLongestValidSegmentFraction(std::min(1.5 / space->getMaximumExtent(), 0.999));

    auto setup = std::make_shared<ompl::geometric::SimpleSetup>(space);
    const auto& si = setup->getSpaceInformation();
    setup->setStateValidityChecker(std::make_shared<GridValidityChecker>(si, problem.map, check));
    setup->setOptimizationObjective(makeObjective(si, cost));
    ob::ScopedState<> start(setup->getStateSpace());
    ob::ScopedState<> goal(setup->getStateSpace());
    for (unsigned axis = 0; axis < 2; ++axis)
    {
        start[axis] = problem.start[axis];
        goal[axis] = problem.goal[axis];
    }
    setup->setStartAndGoalStates(start, goal);
    return setup;
}

PlannerSettings gridPlannerSettings(bool cornerCutting)
{
    PlannerSettings settings;
    settings.spacing = {1.0};
    settings.anytime = false;
    settings.objectiveInChecks = false;
    settings.connectivity = 2;
    settings.cornerCutting = cornerCutting;
    return settings;
}
}  // namespace specplan::problems
