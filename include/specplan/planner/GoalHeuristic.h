// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/Goal.h>
#include <ompl/base/OptimizationObjective.h>

#include "specplan/lattice/Heuristic.h"
#include "specplan/planner/Embedding.h"
#include "specplan/planner/ObjectiveCosts.h"

namespace specplan::planner
{
/// Lower bound of the cost to the nearest goal.
///
/// Where paths are judged by length: the length of the shortest way on a lattice without obstacles, in spaces whose
/// distances OMPL defines; the distance itself in others; the goal's own distance where the goal is a region without
/// states that stand for it. For other objectives: their motionCostHeuristic(). A cost-to-go heuristic that the user
/// gave to the objective counts too.
///
/// Threads: search thread.
class GoalHeuristic : public lattice::Heuristic
{
public:
    /// \param costs of the objective, or nullptr for path length. All references must outlive the heuristic.
    GoalHeuristic(const ompl::base::SpaceInformation& si, const ompl::base::OptimizationObjective& objective,
                  const lattice::Lattice& lattice, const Embedding& embedding, const ObjectiveCosts* costs);

    /// Forgets all goals.
    void clear();

    /// The goal that the states below stand for, and how to tell that a state satisfies it. \param region whether
    /// states other than those added may satisfy the goal. \param start any start state.
    void setGoal(const ompl::base::Goal* goal, bool region, const ompl::base::State* start);

    /// Adds a state that satisfies the goal.
    void addState(const ompl::base::State* state);

    [[nodiscard]] double estimate(lattice::NodeId node) const override;

    /// Whether the estimates are known to be consistent. Otherwise nodes have to be opened again.
    [[nodiscard]] bool isConsistent() const;

    /// Distance of a state to the nearest goal.
    [[nodiscard]] double distance(const ompl::base::State* state) const;

private:
    [[nodiscard]] bool ownCostToGo(const ompl::base::State* start) const;
    [[nodiscard]] double lengthToGo(lattice::NodeId node) const;
    [[nodiscard]] double costToGo() const;
    [[nodiscard]] double none() const;

    const ompl::base::SpaceInformation& si_;
    const ompl::base::OptimizationObjective& objective_;
    const lattice::Lattice& lattice_;
    const Embedding& embedding_;
    const ObjectiveCosts* costs_;

    const ompl::base::Goal* goal_ = nullptr;
    bool region_ = false;
    bool measures_ = false;       ///< the goal's own distance tells how far it is, not the states added
    bool asksObjective_ = false;  ///< the user's cost-to-go heuristic counts
    double threshold_ = 0.0;      ///< how far off a state may be
    std::vector<StateHandle> states_;
    std::vector<Embedding::Target> targets_;
    StateHandle here_;  ///< scratch of estimate()
};
}  // namespace specplan::planner
