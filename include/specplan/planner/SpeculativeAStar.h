// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: OMPL's users build as C++17.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/Planner.h>
#include <ompl/base/StateValidityChecker.h>

#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/SearchReport.h"

namespace specplan
{
namespace planner
{
class PlannerSession;
}

/// A* on a lattice over an OMPL state space, with the validity checks that it is about to need run ahead in parallel.
///
/// Idea: planning with expensive checks is checking. The search expands states in exactly the order of sequential A*;
/// while it waits for a check, idle workers run the checks that it will probably ask for next. Path, cost and
/// optimality are those of sequential A* for every number of threads; only the time changes.
///
/// Reference: M. Bakhshalipour, M. Qadri, D. Guri, "Speculative Path Planning", arXiv:2102.06261.
///
/// Assumptions: the state space is a RealVectorStateSpace with bounds. The goal is a state or a set of states. The
/// lattice goes through the first start exactly; other starts, and goals that lie off the lattice, are joined to the
/// corners of their cell by validated motions. The answer is optimal on this lattice (within `weight`).
///
/// Threads: the planner's members are for one thread at a time. During solve() the state validity checker is called
/// from up to `num_threads` threads, as OMPL asks of checkers; give one for each worker with
/// setStateValidityCheckerAllocator if yours cannot do that. No check runs outside solve().
class SpeculativeAStar : public ompl::base::Planner
{
public:
    /// Makes the checker of one worker, numbered from 0.
    using StateValidityCheckerAllocator =
        std::function<ompl::base::StateValidityCheckerPtr(const ompl::base::SpaceInformationPtr&, unsigned worker)>;
    /// Makes the motion validator of one worker, numbered from 0.
    using MotionValidatorAllocator =
        std::function<ompl::base::MotionValidatorPtr(const ompl::base::SpaceInformationPtr&, unsigned worker)>;

    explicit SpeculativeAStar(const ompl::base::SpaceInformationPtr& si);
    SpeculativeAStar(const ompl::base::SpaceInformationPtr& si, const PlannerSettings& settings);
    ~SpeculativeAStar() override;

    /// Searches until a goal is reached, none can be, or `ptc` says stop; a later call goes on. `ptc` is evaluated in
    /// the calling thread only, once per expansion (and now and then while an expansion takes longer than 50 ms).
    /// \return EXACT_SOLUTION; APPROXIMATE_SOLUTION or TIMEOUT if stopped; INFEASIBLE (ABORT before OMPL 1.6) if no
    /// goal can be reached on this lattice; INVALID_START; INVALID_GOAL; UNRECOGNIZED_GOAL_TYPE; CRASH if a check
    /// threw.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
    using ompl::base::Planner::solve;

    void clear() override;
    void clearQuery() override;
    void setup() override;

    /// \throws ompl::Exception if the space is not a bounded RealVectorStateSpace, or the settings do not fit it.
    void checkValidity() override;

    void getPlannerData(ompl::base::PlannerData& data) const override;

    /// The settings now in force. They take effect with the next solve(), which starts afresh if they have changed.
    const PlannerSettings& getSettings() const;

    /// \throws std::invalid_argument with one line that names the parameter and its range.
    void setSettings(const PlannerSettings& settings);

    /// Gives every worker a checker of its own; an empty function goes back to the shared one.
    void setStateValidityCheckerAllocator(StateValidityCheckerAllocator allocator);

    /// Gives every worker a motion validator of its own. Without it a validator other than OMPL's discrete one, which
    /// this planner replaces by the same test without its counters, is called by one worker at a time.
    void setMotionValidatorAllocator(MotionValidatorAllocator allocator);

    /// What the last solve() did.
    const SearchReport& getReport() const;

    /// What became of a lattice state during the search.
    enum class StateFate
    {
        Expanded,      ///< taken off OPEN
        Open,          ///< reached, valid, not expanded
        Invalid,       ///< checked, needed, and invalid
        CheckedUnused  ///< checked ahead and never needed
    };

    /// Calls `visit` for every lattice state that was expanded or checked; the state is valid during the call only.
    void visitStates(const std::function<void(const ompl::base::State* state, StateFate fate)>& visit) const;

    /// Told about each expanded state in order, in the thread of solve(); for traces. An empty function for none.
    void setExpansionObserver(std::function<void(const ompl::base::State* state)> observer);

private:
    std::unique_ptr<planner::PlannerSession> session_;
};
}  // namespace specplan
