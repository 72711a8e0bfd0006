// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include "specplan/planner/Embedding.h"

namespace specplan::test
{
namespace ob = ompl::base;

/// Dijkstra's algorithm over the planner's lattice, with nothing of the planner but the lattice: states, motions and
/// costs are asked for here, by OMPL's own interfaces, one after the other.
class ReferenceDijkstra
{
public:
    ReferenceDijkstra(const ob::SpaceInformationPtr& si, const ob::OptimizationObjective& objective,
                      const PlannerSettings& settings, const ob::State* origin)
        : si_(si),
          objective_(objective),
          embedding_(*si, settings, {}, origin),
          neighbourhood_(embedding_.neighbourhood(true)),
          lattice_(embedding_.neighbourhood(true))
    {
    }

    /// Best cost from the starts to any goal state, or to any lattice state that satisfies the predicate.
    std::optional<ob::Cost> solve(const std::vector<const ob::State*>& starts,
                                  const std::vector<const ob::State*>& goals,
                                  const std::function<bool(const ob::State*)>& satisfies)
    {
        for (std::size_t i = 0; i < goals.size(); ++i)
            for (const auto& corner : embedding_.corners(goals[i], planner::Component::Joint::Entering))
                entrances_[corner].push_back(i);
        std::optional<ob::Cost> best;
        const auto finish = [&](ob::Cost cost)
        {
            if (!best || objective_.isCostBetterThan(cost, *best))
                best = cost;
        };
        for (const ob::State* start : starts)
        {
            const ob::Cost initial = objective_.initialCost(start);
            if (satisfies && satisfies(start))
                finish(initial);
            const auto corners = embedding_.corners(start, planner::Component::Joint::Leaving);
            for (const auto& corner : corners)
                if (const auto cost = costOf(start, state(corner).get()))
                    reach(corner, objective_.combineCosts(initial, *cost));
            for (const ob::State* goal : goals)
                if (sharesCorner(corners, goal))
                    if (const auto cost = costOf(start, goal))
                        finish(end(objective_.combineCosts(initial, *cost), goal));
        }
        while (!open_.empty())
        {
            auto first = open_.begin();
            for (auto it = open_.begin(); it != open_.end(); ++it)
                if (objective_.isCostBetterThan(it->second, first->second))
                    first = it;
            const auto [node, cost] = *first;
            open_.erase(first);
            closed_[node] = cost;
            const planner::StateHandle here = state(node);
            if (satisfies && satisfies(here.get()))
                finish(cost);
            if (const auto entrance = entrances_.find(node); entrance != entrances_.end())
                for (const std::size_t i : entrance->second)
                    if (const auto more = costOf(here.get(), goals[i]))
                        finish(end(objective_.combineCosts(cost, *more), goals[i]));
            lattice::Steps steps;
            neighbourhood_->steps(node.data(), steps);
            for (std::size_t i = 0; i < steps.count; ++i)
            {
                const auto* to = &steps.ends[i * node.size()];
                const Node next(to, to + node.size());
                if (closed_.count(next) == 0)
                    if (const auto more = costOf(here.get(), state(next).get()))
                        reach(next, objective_.combineCosts(cost, *more));
            }
        }
        return best;
    }

private:
    using Node = std::vector<lattice::Coordinate>;

    [[nodiscard]] planner::StateHandle state(const Node& node)
    {
        planner::StateHandle made(*si_);
        embedding_.write(lattice_, lattice_.node(node.data()), made.get());
        return made;
    }

    [[nodiscard]] bool sharesCorner(const std::vector<Node>& corners, const ob::State* goal) const
    {
        for (const auto& corner : embedding_.corners(goal, planner::Component::Joint::Entering))
            for (const auto& other : corners)
                if (corner == other)
                    return true;
        return false;
    }

    /// Cost of a motion; nothing if it or its end is invalid.
    [[nodiscard]] std::optional<ob::Cost> costOf(const ob::State* from, const ob::State* to) const
    {
        if (si_->equalStates(from, to))
            return objective_.identityCost();  // no motion at all
        const unsigned segments = embedding_.segments(from, to);
        const planner::StateHandle between(*si_);
        for (unsigned i = 1; i <= segments; ++i)
        {
            si_->getStateSpace()->interpolate(from, to, static_cast<double>(i) / segments, between.get());
            const ob::State* at = i == segments ? to : between.get();
            if ((embedding_.curves() && !si_->satisfiesBounds(at)) || !si_->isValid(at))
                return std::nullopt;
        }
        return objective_.motionCost(from, to);
    }

    [[nodiscard]] ob::Cost end(ob::Cost cost, const ob::State* goal) const
    {
        return objective_.combineCosts(cost, objective_.terminalCost(goal));
    }

    void reach(const Node& node, ob::Cost cost)
    {
        if (closed_.count(node) != 0)
            return;
        const auto [found, fresh] = open_.emplace(node, cost);
        if (!fresh && objective_.isCostBetterThan(cost, found->second))
            found->second = cost;
    }

    ob::SpaceInformationPtr si_;
    const ob::OptimizationObjective& objective_;
    planner::Embedding embedding_;
    std::unique_ptr<const lattice::Neighbourhood> neighbourhood_;
    lattice::Lattice lattice_;
    std::map<Node, std::vector<std::size_t>> entrances_;
    std::map<Node, ob::Cost> open_;
    std::map<Node, ob::Cost> closed_;
};
}  // namespace specplan::test
