// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <ompl/base/OptimizationObjective.h>

#include "specplan/planner/Embedding.h"
#include "specplan/planner/GoalHeuristic.h"
#include "specplan/planner/ObjectiveCosts.h"
#include "specplan/planner/OmplChecker.h"
#include "specplan/planner/PlannerSettings.h"
#include "specplan/search/AStar.h"
#include "specplan/search/LazySearch.h"
#include "specplan/speculation/Predictor.h"
#include "specplan/validity/Broker.h"

namespace specplan::planner
{
/// A lattice through its first start, what is known of its states, and one planning query after the other over it.
///
/// Starts and goals may be added later on, and the lattice may be refined; the search then begins again and finds every
/// verdict still there. So does the next query.
///
/// Threads: search thread only.
class LatticeQuery
{
public:
    /// \param objective shared so that it lives as long as the query. \param origin the first start. \param coarsens
    /// whether a lattice of twice the usual spacing may be searched, too.
    /// \throws ompl::Exception if the settings do not fit the space.
    LatticeQuery(const ompl::base::SpaceInformation& si, ompl::base::OptimizationObjectivePtr objective,
                 const PlannerSettings& settings, const SpaceHooks& hooks, validity::Executor& executor,
                 OmplChecker& checker, OmplChecker::Sources sources, const ompl::base::State* origin, bool coarsens);

    /// Forgets starts, goals and the search. Verdicts stay.
    void beginQuery();

    /// Adds valid states; `beginSearch` has to follow, or `goalsChanged` after goals that come up during a search.
    void addStart(const ompl::base::State* state);
    void addGoal(const ompl::base::State* state);

    /// Makes sure that states which the planner writes are as good as the first start, as far as that can be told.
    /// \throws ompl::Exception with one line.
    void requireWholeStates() const;

    /// Sets the goal that the goal states stand for, after the starts. \param region whether other states may satisfy
    /// it.
    void setGoal(const ompl::base::GoalPtr& goal, bool region);

    /// Begins the search afresh with all starts and goals so far. \param weight of the heuristic, at least 1.
    void beginSearch(double weight);

    /// Told of each state in the order in which the search comes to it. Empty for none.
    void setObserver(std::function<void(lattice::NodeId node)> observer);

    /// Lets the search take up goals that were added after it began.
    void goalsChanged();

    /// Halves the spacing of the lattice; `beginSearch` has to follow. \return false if that is not possible.
    bool refine();

    /// Doubles the spacing of places until the next `refine`, see Embedding; `beginSearch` has to follow.
    void coarsen();

    /// Whether lazy evaluation is possible for this objective and these goals.
    [[nodiscard]] bool canBeLazy() const;

    /// Whether the search checks lazily.
    [[nodiscard]] bool isLazy() const noexcept
    {
        return settings_.evaluation == "lazy" && canBeLazy();
    }

    /// What is wanted of a path.
    enum class Wish
    {
        AnyPath,     ///< no objective was given
        BestPath,    ///< one that is as good as the settings promise
        BetterPaths  ///< one, soon to be followed by better ones
    };

    /// Weight that the settings stand for; 1 for searches that have none.
    [[nodiscard]] double firstWeight(Wish wish) const;

    /// Whether costs add up, so that weights have a meaning.
    [[nodiscard]] bool addsCosts() const noexcept
    {
        return !costs_ || costs_->adds();
    }

    [[nodiscard]] bool isBetter(ompl::base::Cost cost, ompl::base::Cost other) const
    {
        return objective_->isCostBetterThan(cost, other);
    }

    /// Whether `beginSearch` has been called for this query.
    [[nodiscard]] bool isSearching() const noexcept
    {
        return search_ != nullptr;
    }

    [[nodiscard]] search::LatticeSearch& search() noexcept
    {
        return *search_;
    }

    [[nodiscard]] const search::LatticeSearch& search() const noexcept
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

    [[nodiscard]] lattice::Lattice& lattice() noexcept
    {
        return lattice_;
    }

    /// Lower bounds of the way to the goals.
    [[nodiscard]] const lattice::Heuristic& heuristic() const noexcept
    {
        return heuristic_;
    }

    [[nodiscard]] const Embedding& embedding() const noexcept
    {
        return embedding_;
    }

    [[nodiscard]] const std::vector<lattice::NodeId>& starts() const noexcept
    {
        return startNodes_;
    }

    [[nodiscard]] const std::vector<lattice::NodeId>& goals() const noexcept
    {
        return goalNodes_;
    }

    /// Writes all motions out of a node.
    void successors(lattice::NodeId node, lattice::Successors& out) const;

    /// Whether nodes never have to be opened again.
    [[nodiscard]] bool isConsistent() const
    {
        return heuristic_.isConsistent();
    }

    /// Whether states other than the goal states may satisfy the goal.
    [[nodiscard]] bool takesRegion() const noexcept
    {
        return region_;
    }

    /// A new state with the values of a node.
    [[nodiscard]] StateHandle stateOf(lattice::NodeId node) const;

    /// Cost of the best way found to a node.
    [[nodiscard]] ompl::base::Cost costToCome(lattice::NodeId node) const;

    /// Cost of the last motion of the best way found to a node; 0 for starts.
    [[nodiscard]] ompl::base::Cost costOfMotionTo(lattice::NodeId node) const;

    /// Reached node that lies nearest to a goal, and its distance; of equals the cheapest to reach.
    struct Nearest
    {
        lattice::NodeId node;
        double distance;
    };
    [[nodiscard]] Nearest nearestToGoal() const;

private:
    [[nodiscard]] std::optional<lattice::NodeId> nodeExactlyAt(const ompl::base::State* state,
                                                               const std::vector<Embedding::Coordinates>& corners);
    [[nodiscard]] std::unique_ptr<speculation::Predictor> makePredictor();
    [[nodiscard]] std::unique_ptr<speculation::Policy> makePolicy();
    void beginEagerSearch();
    void beginLazySearch();
    [[nodiscard]] bool isWorthAGlance(const lattice::Lattice::Motion& motion) const;
    void takeNewSpacing();
    void dropSearch();
    /// A terminal at this state; the one of an earlier query if there is one.
    lattice::NodeId terminalAt(const ompl::base::State* state);
    lattice::NodeId nodeFor(const ompl::base::State* state, Embedding::Joint joint);
    void joinToLattice(lattice::NodeId terminal, Embedding::Joint joint,
                       const std::vector<Embedding::Coordinates>& corners);
    void join(lattice::NodeId from, lattice::NodeId to);
    [[nodiscard]] double motionCost(lattice::NodeId from, lattice::NodeId to) const;
    /// Joins a start and a goal off the lattice that share a node next to them: no detour over it.
    void joinNeighbours(lattice::NodeId start, lattice::NodeId goal);
    /// Order of nodes that does not depend on when they were first touched.
    [[nodiscard]] bool comesBefore(lattice::NodeId node, lattice::NodeId other) const;

    const ompl::base::SpaceInformation& si_;
    ompl::base::OptimizationObjectivePtr objective_;
    PlannerSettings settings_;
    bool discreteMotions_;
    Embedding embedding_;
    mutable lattice::Lattice lattice_;     ///< looking at motions makes their nodes
    std::optional<ObjectiveCosts> costs_;  ///< empty for path length
    StateHandle from_;                     ///< scratch of motionCost() and isWorthAGlance()
    StateHandle to_;                       ///< the same
    validity::Broker broker_;
    std::unique_ptr<speculation::Predictor> predictor_;
    bool speculates_ = false;
    unsigned workers_ = 1;
    GoalHeuristic heuristic_;
    ompl::base::GoalPtr goal_;
    bool region_ = false;
    std::unique_ptr<search::LatticeSearch> search_;
    search::AStar* eager_ = nullptr;               ///< the search, if it evaluates eagerly
    search::LazySearch* lazy_ = nullptr;           ///< the search, if it evaluates lazily
    double weight_ = 1.0;                          ///< of the search
    std::unique_ptr<speculation::Policy> policy_;  ///< of this search
    std::vector<StateHandle> startStates_;
    std::vector<StateHandle> goalStates_;
    std::vector<lattice::NodeId> startNodes_;
    std::vector<lattice::NodeId> goalNodes_;
    std::vector<StateHandle> terminalStates_;
    std::vector<lattice::NodeId> terminals_;
};
}  // namespace specplan::planner
