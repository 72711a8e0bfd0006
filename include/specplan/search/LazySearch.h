// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "specplan/search/LatticeSearch.h"
#include "specplan/search/LazyTree.h"
#include "specplan/speculation/NearbyPredictor.h"
#include "specplan/validity/Broker.h"

namespace specplan::search
{
using lattice::CheckId;

/// Which unknown checks of the best path come first. States always come before motions.
enum class Selector
{
    LeastLikely,  ///< the least likely to be valid; of several the nearest to the goal
    Forward,      ///< the nearest to the start
    Backward,     ///< the nearest to the goal
    Alternate     ///< from both ends in turn
};

/// Lazy shortest-path search: takes the unknown for valid, finds the shortest path, checks it, and repeats where that
/// fails. Needs far fewer checks than A* for a path of the same cost, and more work of its own for each.
///
/// Idea: LazySP (Dellin, Srinivasa 2016) on an incremental search, see LazyTree. The search is a series of decisions,
/// each of which demands some checks that are hardly less needed than the first of them: so they can run at the same
/// time, and the search is brought up to date once for all of them. While it waits it runs ahead of itself: it takes
/// predicted verdicts for the checks that are still open, goes on deciding, and proposes the checks that it meets. What
/// was decided on a wrong guess is taken back. So the decisions, the path and its cost are the same whoever runs the
/// checks, and whenever. The numbers in the comments of the body are those of docs/algorithm.md.
///
/// Where a state is doubtful, because one beside it is known to be invalid, it is checked before ways are built on it:
/// so the search follows the edges of obstacles instead of running into them again and again.
///
/// Holds between calls: the heuristic is constant and consistent.
///
/// Threads: one, the search thread.
class LazySearch : public LatticeSearch, public validity::CheckSource
{
public:
    /// All references must outlive the search. Pass it to Broker::setSource to let it run ahead.
    /// \param weight of the heuristic, at least 1: the path costs at most this many times the optimum.
    LazySearch(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, validity::Broker& broker,
               double weight = 1.0);

    /// To be set before the search starts.
    void setSelector(Selector selector) noexcept
    {
        selector_ = selector;
    }

    /// Motions of which a glance is taken before they are checked, if the lattice has glances; empty for none. To be
    /// set before the search starts.
    void setGlances(std::function<bool(const lattice::Lattice::Motion&)> isLong)
    {
        isLong_ = std::move(isLong);
    }

    /// Told about every decision in order: the check, and its verdict. Empty for none.
    void setObserver(std::function<void(CheckId check, bool valid)> observer)
    {
        observer_ = std::move(observer);
    }

    /// Adds a start; its state must be known to be valid.
    void addStart(NodeId start)
    {
        tree_.addStart(start);
    }

    /// Adds a goal. Its state is checked like any other.
    void addGoal(NodeId goal)
    {
        tree_.addGoal(goal);
    }

    /// Searches until a path to a goal is known to be valid, there is none, or `stop` returns true; `stop` is asked
    /// once per decision, and now and then while a path is sought. \throws what a check threw that the search needs.
    /// The search can go on after that.
    SearchStatus run(const std::function<bool()>& stop) override;

    /// The goal that the valid path leads to, or kNoNode.
    [[nodiscard]] NodeId reachedGoal() const noexcept override
    {
        return solution_.empty() ? lattice::kNoNode : solution_.back();
    }

    /// The valid path from a start to `node`; empty if the node is not on it.
    [[nodiscard]] std::vector<NodeId> pathTo(NodeId node) const override;

    /// Cost of the valid path from a start to `node`; infinite if the node is not on it.
    [[nodiscard]] double costToCome(NodeId node) const noexcept override;

    [[nodiscard]] bool isReached(NodeId node) const noexcept override
    {
        return costToCome(node) < LazyTree::kUnreached;
    }

    /// Node before `node` on the valid path, or kNoNode.
    [[nodiscard]] NodeId parent(NodeId node) const noexcept override;

    [[nodiscard]] bool isGoal(NodeId node) const noexcept
    {
        return tree_.isGoal(node);
    }

    /// Whether the search has demanded the node's state.
    [[nodiscard]] bool isExpanded(NodeId node) const noexcept override
    {
        return broker_.isUsed(CheckId::ofState(node));
    }

    /// Number of decisions, each of which demanded some checks.
    [[nodiscard]] std::uint64_t decisions() const noexcept
    {
        return decisions_;
    }

    /// Number of checks that decisions have asked for.
    [[nodiscard]] std::uint64_t steps() const noexcept override
    {
        return steps_;
    }

    /// Nodes expanded to keep the shortest path up to date, those of wrong guesses included: work, not progress.
    [[nodiscard]] std::uint64_t expansions() const noexcept
    {
        return tree_.expansions();
    }

    /// Hash of all decisions in order, by coordinates: equal for equal sequences.
    [[nodiscard]] std::uint64_t orderHash() const noexcept override
    {
        return orderHash_;
    }

    void proposeAtHand(std::size_t count, std::vector<CheckId>& out) override;
    void propose(std::size_t count, std::vector<CheckId>& out) override;
    void learned(CheckId check, bool valid) override;
    void missed() override;
    [[nodiscard]] bool stillWanted(CheckId check) const override;

    [[nodiscard]] bool keepsAsking() const noexcept override
    {
        return true;
    }

private:
    /// How a check may turn out.
    struct Foreseen
    {
        CheckId check;
        bool valid;
        double probability;  ///< that the check is valid
    };

    /// A check that the search has taken into account ahead of time.
    struct Guess : Foreseen
    {
        bool isLast;                   ///< of those of one decision
        std::vector<NodeId> suspects;  ///< before this guess
        LazyTree::Journal journal;     ///< all changes from this guess to the next
    };

    enum class Plan
    {
        Unfinished,
        Next,   ///< next_ are the checks to demand
        Valid,  ///< nothing on the path is unknown
        NoWay   ///< no goal can be reached
    };

    [[nodiscard]] Plan plan(std::size_t budget);
    [[nodiscard]] bool chooseSuspects();
    void demandDoubtful();
    void readPath();
    void listUnknown(CheckId check);
    [[nodiscard]] std::vector<CheckId>& listOf(CheckId check) noexcept;
    [[nodiscard]] const std::vector<CheckId>& firstUnknown() const noexcept;
    void choose();
    void suspectAround(NodeId node);
    void enter(CheckId check, bool valid);
    void commit(CheckId check, bool valid);
    void note(CheckId check, bool valid);
    void finish();

    // Running ahead.
    [[nodiscard]] bool isAmidRepair() const noexcept
    {
        return demanded_.empty();
    }
    void lookAhead(std::size_t most, std::vector<CheckId>& out);
    void addUnknown(CheckId check, std::size_t most, std::vector<CheckId>& out) const;
    [[nodiscard]] bool isLikely(CheckId check) const;
    void guess(std::span<const Foreseen> decision);
    [[nodiscard]] std::size_t beginOfDecision(std::size_t guess) const;
    [[nodiscard]] std::size_t endOfDecision(std::size_t guess) const;
    void takeBack(std::size_t first);
    [[nodiscard]] bool doubtPath();
    [[nodiscard]] double probabilityValid(CheckId check) const;

    lattice::Lattice& lattice_;
    validity::Broker& broker_;
    LazyTree tree_;
    speculation::NearbyPredictor predictor_;
    Selector selector_ = Selector::LeastLikely;
    std::function<void(CheckId, bool)> observer_;
    std::function<bool(const lattice::Lattice::Motion&)> isLong_;

    Plan plan_ = Plan::Unfinished;        ///< after all guesses
    bool pathHolds_ = false;              ///< path_ and what is unknown of it are up to date
    std::vector<CheckId> next_;           ///< if plan_ is Next; in order
    std::vector<LazyTree::EdgeId> path_;  ///< last motion first
    std::vector<CheckId> unknownStates_;  ///< of path_, in its order
    std::vector<CheckId> unknownGlances_;
    std::vector<CheckId> unknownMotions_;
    std::vector<NodeId> suspects_;  ///< doubtful nodes that ways may lead through
    std::deque<Guess> guesses_;     ///< in order of deciding; what is committed is off the list
    std::size_t spentOnGuess_ = 0;  ///< nodes expanded since the last guess
    bool stuck_ = false;            ///< the last guess takes more work than a guess is worth
    std::uint64_t decisions_ = 0;
    std::uint64_t steps_ = 0;
    std::uint64_t orderHash_ = 0;
    std::vector<NodeId> solution_;
    std::vector<double> solutionCosts_;  ///< parallel to solution_: cost from the start
    lattice::Successors successors_;     ///< scratch
    std::vector<NodeId> neighbours_;     ///< scratch of suspectAround()
    std::vector<CheckId> demanded_;      ///< by the last decision; empty while the next one is sought
    std::vector<NodeId> doubtful_;       ///< where the repair stands
    std::size_t lookedAhead_ = 0;        ///< number of entries of OPEN looked at since the last decision
    std::size_t goneRound_ = 0;          ///< the same of those behind its front, since ever
    std::vector<Foreseen> guessed_;      ///< scratch of propose()
    std::vector<CheckId> inner_;         ///< scratch of readPath()
    std::vector<CheckId> inOrder_;       ///< scratch of choose()
};
}  // namespace specplan::search
