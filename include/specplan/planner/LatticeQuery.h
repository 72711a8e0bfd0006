// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <ompl/base/OptimizationObjective.h>

#include "specplan/lattice/GridHeuristic.h"
#include "specplan/planner/ObjectiveCost.h"
#include "specplan/planner/OmplChecker.h"
#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/RealVectorEmbedding.h"
#include "specplan/search/AStar.h"
#include "specplan/speculation/Predictor.h"
#include "specplan/validity/Broker.h"

namespace specplan::planner
{
/// One planning query: the lattice through its first start, what is known of its states, and the search over it.
///
/// Starts and goals may be added later on; the search then begins again and finds every verdict still there.
///
/// Threads: search thread only.
class LatticeQuery
{
public:
    /// \param objective additive; shared so that it lives as long as the query. \param origin the first start.
    /// \throws ompl::Exception if the settings do not fit the space.
    LatticeQuery(const ompl::base::SpaceInformation& si, ompl::base::OptimizationObjectivePtr objective,
                 const PlannerSettings& settings, validity::Executor& executor, OmplChecker& checker,
                 OmplChecker::Sources sources, const ompl::base::State* origin);

    /// Adds valid states; `beginSearch` has to follow.
    void addStart(const ompl::base::State* state);
    void addGoal(const ompl::base::State* state);

    /// Begins the search afresh with all starts and goals so far.
    void beginSearch();

    [[nodiscard]] search::AStar& search() noexcept
    {
        return *search_;
    }

    [[nodiscard]] const search::AStar& search() const noexcept
    {
        return *search_;
    }

    [[nodiscard]] validity::Broker& broker() noexcept
    {
        return broker_;
    }

    [[nodiscard]] const validity::Broker& broker() const noexcept
    {
        return broker_;
    }

    [[nodiscard]] const lattice::Lattice& lattice() const noexcept
    {
        return lattice_;
    }

    [[nodiscard]] const std::vector<lattice::NodeId>& starts() const noexcept
    {
        return startNodes_;
    }

    [[nodiscard]] const std::vector<lattice::NodeId>& goals() const noexcept
    {
        return goalNodes_;
    }

    /// A new state with the values of a node.
    [[nodiscard]] StateHandle stateOf(lattice::NodeId node) const;

    /// Reached node that lies nearest to a goal, and its distance; of equals the cheapest to reach.
    struct Nearest
    {
        lattice::NodeId node;
        double distance;
    };
    [[nodiscard]] Nearest nearestToGoal() const;

private:
    [[nodiscard]] std::unique_ptr<lattice::GridNeighbourhood> makeNeighbourhood(bool discreteMotions) const;
    [[nodiscard]] std::optional<lattice::NodeId> nodeExactlyAt(const ompl::base::State* state);
    [[nodiscard]] std::unique_ptr<speculation::Predictor> makePredictor();
    [[nodiscard]] std::unique_ptr<speculation::Policy> makePolicy();
    lattice::NodeId addTerminal(const ompl::base::State* state);
    void join(lattice::NodeId from, lattice::NodeId to);
    /// Joins a start and a goal off the lattice that are less than a step apart: no detour over a corner.
    void joinNeighbours(lattice::NodeId start, lattice::NodeId goal);
    /// Order of nodes that does not depend on when they were first touched.
    [[nodiscard]] bool comesBefore(lattice::NodeId node, lattice::NodeId other) const;
    [[nodiscard]] double distanceToGoal(const ompl::base::State* state) const;

    const ompl::base::SpaceInformation& si_;
    ompl::base::OptimizationObjectivePtr objective_;
    PlannerSettings settings_;
    RealVectorEmbedding embedding_;
    lattice::Lattice lattice_;
    std::optional<ObjectiveCost> motionCost_;  ///< empty for path length
    validity::Broker broker_;
    std::unique_ptr<speculation::Predictor> predictor_;
    bool speculates_ = false;
    lattice::GridHeuristic gridHeuristic_;
    ObjectiveHeuristic objectiveHeuristic_;
    std::unique_ptr<search::AStar> search_;
    std::unique_ptr<speculation::Policy> policy_;  ///< of this search
    std::vector<StateHandle> goalStates_;
    std::vector<lattice::NodeId> startNodes_;
    std::vector<lattice::NodeId> goalNodes_;
};
}  // namespace specplan::planner
