// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: OMPL's users build as C++17.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/Planner.h>
#include <ompl/base/StateValidityChecker.h>

#include "specplan/planner/BuiltWithOmpl.h"
#include "specplan/planner/LatticeAxes.h"
#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/SearchReport.h"
#include "specplan/validity/ThreadBudget.h"

namespace specplan
{
namespace planner
{
class CheckTrace;
class PlannerSession;
}  // namespace planner

/// A* on a lattice over an OMPL state space, with the validity checks that it is about to need run ahead in parallel.
///
/// Idea: planning with expensive checks is checking. The search expands states in exactly the order of sequential A*;
/// while it waits for a check, idle workers run the checks that it will probably ask for next. Path, cost and
/// optimality are those of sequential A* for every number of threads; only the time changes.
///
/// Reference: M. Bakhshalipour, M. Qadri, D. Guri, "Speculative Path Planning", arXiv:2102.06261.
///
/// Assumptions: the state space has bounds. Nearly any space that OMPL ships will do, combined in any way, and any
/// other one whose values say all about a state (StateSpace::copyToReals); those constrained to a manifold and those
/// whose motions are curves will not, but for cars. Any goal will do; states are joined to the lattice by validated
/// motions, and regions are entered at lattice states. Any objective will do that prefers smaller or larger costs. The
/// lattice goes through the first start exactly. The answer is optimal on this lattice within `weight`. With time left
/// and an objective in the problem definition, the planner goes on with smaller weights and finer lattices. Without an
/// objective the first path is the answer, and it is looked for in haste: its cost is at most 3 times the optimum on
/// the lattice (5 times from eight axes on).
///
/// Threads: the planner's members are for one thread at a time. During solve() the state validity checker is called
/// from up to `num_threads` threads, as OMPL asks of checkers; give one for each worker with
/// setStateValidityCheckerAllocator if yours cannot do that. docs/thread-safety.md says the same of motion validators,
/// objectives, goals, spaces and conditions. No check runs outside solve().
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
    /// the calling thread only, before each expansion and each motion's check, and every few milliseconds while either
    /// lasts. Then no check begins any more, and motions are broken off between two states: the call returns within the
    /// check of one state and 5 ms. Motion validators of one's own, and objectives, cannot be broken off. \return
    /// EXACT_SOLUTION; APPROXIMATE_SOLUTION or TIMEOUT if stopped; INFEASIBLE (ABORT before OMPL 1.6) if no goal can be
    /// reached on this lattice; INVALID_START; INVALID_GOAL; UNRECOGNIZED_GOAL_TYPE; CRASH if a check threw, or
    /// the space or the settings are refused: the report says why.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
    using ompl::base::Planner::solve;

    /// Forgets everything but the settings.
    void clear() override;

    /// Forgets starts, goals and solutions. What is known of states and motions stays for the next query, as long as
    /// checker, motion validator, objective and space stay what they are.
    void clearQuery() override;

    /// Forgets what is known of states and motions: to be called when the world has changed behind the same checker.
    /// The next solve() starts afresh.
    void forgetVerdicts();

    /// Also starts the threads, at most as many as there are processors, so that no search has to. They sleep outside
    /// of solve(). Warns of settings that do not fit the space.
    void setup() override;

    /// \throws ompl::Exception if there is no lattice over the space.
    void checkValidity() override;

    /// A dry run: tells which lattice would be searched - its axes, steps, size, the checks that motions need, how the
    /// goal is reached. Checks no more than starts and goals. Needs a problem definition, as solve() does; SimpleSetup
    /// hands it over in its setup().
    /// \throws ompl::Exception without one, as checkValidity() does, and if the settings do not fit the space.
    void explain(std::ostream& out);

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

    /// Fills in a state of the user's own class after the planner has written its values: derived data such as poses,
    /// or values that others determine. `complete` gets every lattice state before anybody else sees it, and changes no
    /// value that is an axis. It is called by up to `num_threads` workers at once, each with a state of its own: what
    /// it shares has to be thread-safe. States that OMPL makes are not handed to it: those of interpolate() and
    /// copyState() have to be whole by themselves. An empty function for none. The next solve() starts afresh.
    void setStateCompleter(std::function<void(ompl::base::State* state)> complete);

    /// Describes the state space, or a part of it, where the planner cannot tell its axes, or should not guess.
    /// Replaces what was said of the same space; no axes take it back. The next solve() starts afresh. \throws
    /// std::invalid_argument with one line that names the axis.
    void setLatticeAxes(const LatticeAxes& axes);

    /// Lets planners that solve at the same time share so many threads; a null pointer for none to be shared. No more
    /// than the budget's threads are then used, whatever `num_threads` says, and none starts before there is work.
    /// Results are the same with every budget. The next solve() may wait for one check of another planner.
    void setThreadBudget(std::shared_ptr<ThreadBudget> budget);

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

    /// From the next solve() on, which starts afresh, keeps what each check finds and how long it takes in this trace;
    /// an empty one is for none. On the virtual clock a trace is replayed instead: what it knows is not checked again,
    /// what it does not know is checked once, and the clock tells what that many threads would take on as many
    /// processors, the search's own work included. `virtual_check_cost` means nothing then.
    void setCheckTrace(std::shared_ptr<planner::CheckTrace> trace);

    /// One check that has run.
    struct CheckRun
    {
        const ompl::base::State* from;  ///< the state; of a motion its beginning
        const ompl::base::State* to;    ///< end of the motion; nullptr for the check of a state
        bool valid;
        bool used;       ///< whether the search has asked for the verdict
        double start;    ///< seconds since the first check began
        double seconds;  ///< duration
        unsigned worker;
        bool glance;  ///< looked at a few states of the motion only
    };

    /// Calls `visit` for every check that has run since the trace was set, in the order in which they began; the states
    /// are valid during the call only. Nothing without a trace.
    void visitChecks(const std::function<void(const CheckRun& check)>& visit) const;

    /// Told about each expanded state in order, in the thread of solve(); for traces. An empty function for none.
    void setExpansionObserver(std::function<void(const ompl::base::State* state)> observer);

private:
    void requireLattice() const;
    void warnOfSettings() const;

    std::unique_ptr<planner::PlannerSession> session_;
};
}  // namespace specplan
