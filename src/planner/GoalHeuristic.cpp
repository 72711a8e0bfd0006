// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/GoalHeuristic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ompl/base/goals/GoalRegion.h>

#include "specplan/planner/Distance.h"

namespace specplan::planner
{
namespace ob = ompl::base;

GoalHeuristic::GoalHeuristic(const ob::SpaceInformation& si, const ob::OptimizationObjective& objective,
                             const lattice::Lattice& lattice, const Embedding& embedding, const ObjectiveCosts* costs)
    : si_(si), objective_(objective), lattice_(lattice), embedding_(embedding), costs_(costs), here_(si)
{
}

void GoalHeuristic::clear()
{
    goal_ = nullptr;
    region_ = false;
    measures_ = false;
    asksObjective_ = false;
    states_.clear();
    targets_.clear();
}

void GoalHeuristic::setGoal(const ob::Goal* goal, bool region, const ob::State* start)
{
    goal_ = goal;
    region_ = region;
    const bool isRegion = goal->hasType(ob::GOAL_REGION);
    measures_ = !goal->hasType(ob::GOAL_STATE) && !goal->hasType(ob::GOAL_STATES);
    threshold_ = region && isRegion ? goal->as<ob::GoalRegion>()->getThreshold() : 0.0;
    // OMPL's default for path length is the distance to the goal, which the lattice knows better.
    asksObjective_ = isRegion && objective_.hasCostToGoHeuristic() && (costs_ != nullptr || ownCostToGo(start));
}

/// Whether the cost to go is not OMPL's. The user's code gets copies of the start, since it may write into them.
bool GoalHeuristic::ownCostToGo(const ob::State* start) const
{
    const StateHandle one(si_, start);
    const StateHandle other(si_, start);
    return objective_.costToGo(one.get(), goal_).value() != ob::goalRegionCostToGo(other.get(), goal_).value();
}

void GoalHeuristic::addState(const ob::State* state)
{
    states_.emplace_back(si_, state);
    targets_.push_back(embedding_.target(state, !region_));
}

bool GoalHeuristic::isConsistent() const
{
    return costs_ == nullptr && !asksObjective_ && !measures_ &&
           (embedding_.sumsDistances() || si_.getStateSpace()->isMetricSpace());
}

double GoalHeuristic::none() const
{
    return costs_ == nullptr ? 0.0 : costs_->identity();
}

double GoalHeuristic::estimate(lattice::NodeId node) const
{
    if (lattice_.isTerminal(node))
        return none();  // a goal is reached, and nothing better is promised of a start off the lattice
    const bool needsState = costs_ != nullptr || asksObjective_ || !embedding_.sumsDistances() || measures_;
    if (needsState)
        embedding_.write(lattice_, node, here_.get());
    double estimate = costs_ == nullptr ? lengthToGo(node) : costToGo();
    if (asksObjective_)
    {
        const ob::Cost users = objective_.costToGo(here_.get(), goal_);
        estimate = std::max(estimate, costs_ == nullptr ? users.value() : costs_->bound(users));
    }
    return estimate;
}

double GoalHeuristic::lengthToGo(lattice::NodeId node) const
{
    double nearest = std::numeric_limits<double>::infinity();
    if (measures_)
    {
        goal_->isSatisfied(here_.get(), &nearest);
        if (!std::isfinite(nearest) || !goal_->hasType(ob::GOAL_REGION))
            return 0.0;  // the goal knows no distance
    }
    else if (embedding_.sumsDistances())
    {
        const lattice::Coordinate* coordinates = lattice_.coordinates(node).data();
        for (const Embedding::Target& target : targets_)
            nearest = std::min(nearest, embedding_.lowerBound(coordinates, target));
    }
    else
    {
        for (const StateHandle& state : states_)
            nearest = std::min(nearest, planner::distance(si_, here_.get(), state.get()));
    }
    return states_.empty() && !measures_ ? 0.0 : std::max(nearest - threshold_, 0.0);
}

double GoalHeuristic::costToGo() const
{
    if (states_.empty() || region_)
        return none();
    double nearest = std::numeric_limits<double>::infinity();
    for (const StateHandle& state : states_)
        nearest = std::min(nearest, costs_->bound(objective_.motionCostHeuristic(here_.get(), state.get())));
    return nearest;
}

double GoalHeuristic::distance(const ob::State* state) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const StateHandle& goal : states_)
        nearest = std::min(nearest, si_.distance(state, goal.get()));
    if (states_.empty() && goal_ != nullptr)
        goal_->isSatisfied(state, &nearest);
    return nearest;
}
}  // namespace specplan::planner
