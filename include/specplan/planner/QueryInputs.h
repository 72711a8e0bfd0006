// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalSampleableRegion.h>

#include "specplan/planner/StateHandle.h"

namespace specplan::planner
{
/// Takes starts and goals out of a problem definition, one after the other, and checks them; knows whether more may
/// come up, and whether the definition still asks what it asked before.
///
/// Does what OMPL's PlannerInputStates does, but looks at the termination condition between two checks, does not wait
/// for goals that cannot come up, refuses values that are not numbers, and notices starts and goals that were replaced.
///
/// Threads: search thread, while no check runs.
class QueryInputs
{
public:
    explicit QueryInputs(const ompl::base::SpaceInformation& si);

    /// Whether this is the definition whose starts and goals were taken so far, and all that was taken is still in it.
    /// More may have come up.
    [[nodiscard]] bool continues(const ompl::base::ProblemDefinitionPtr& pdef) const;

    /// From now on takes starts and goals from this definition, from the first ones on.
    void open(const ompl::base::ProblemDefinitionPtr& pdef);

    /// Forgets the definition.
    void close();

    /// The next valid start; nullptr if there is none, or `ptc` says stop. Lives as long as the definition holds it.
    [[nodiscard]] const ompl::base::State* nextStart(const ompl::base::PlannerTerminationCondition& ptc);

    /// Whether there are starts that were not looked at.
    [[nodiscard]] bool hasStart() const;

    /// The next valid goal state of those that can be had now; nullptr if there is none, or `ptc` says stop. Does not
    /// wait. Lives until the next call.
    [[nodiscard]] const ompl::base::State* nextGoal(const ompl::base::PlannerTerminationCondition& ptc);

    /// Whether a goal state can be had now: a state that was not looked at, or a sample.
    [[nodiscard]] bool hasGoal() const;

    /// Whether goal states may come up that cannot be had now.
    [[nodiscard]] bool mayGetGoals() const;

    /// Whether goal states were seen to come up one after the other.
    [[nodiscard]] bool isGrowing() const noexcept
    {
        return growing_;
    }

    /// Goal states looked at, valid or not.
    [[nodiscard]] std::size_t goalsSeen() const noexcept
    {
        return goalsSeen_;
    }

    /// Checks run so far: of starts and goals, valid or not.
    [[nodiscard]] std::uint64_t checksRun() const noexcept
    {
        return checksRun_;
    }

private:
    [[nodiscard]] bool isUsable(const ompl::base::State* state, const char* kind, std::size_t number);
    [[nodiscard]] const ompl::base::GoalSampleableRegion* sampleable() const;
    [[nodiscard]] bool sameStarts(const ompl::base::ProblemDefinition& pdef) const;
    [[nodiscard]] bool sameGoals(const ompl::base::Goal& goal) const;
    void rememberGoals();

    const ompl::base::SpaceInformation& si_;
    std::weak_ptr<const ompl::base::ProblemDefinition> pdef_;
    std::weak_ptr<const ompl::base::Goal> goal_;
    double threshold_ = 0.0;           ///< of the goal, if it is a region
    std::vector<StateHandle> starts_;  ///< looked at, as they were then
    std::vector<StateHandle> goals_;   ///< states that the goal was made up of, as they were then
    std::size_t goalsSeen_ = 0;
    StateHandle sample_;                 ///< the last goal state
    mutable std::size_t mostGoals_ = 0;  ///< largest number of goal states that could be had in all
    mutable bool growing_ = false;       ///< that number was seen to grow, or none could be had yet
    std::uint64_t checksRun_ = 0;
};

/// The first value of a state that is not a finite number, in words; empty if all are.
[[nodiscard]] std::string oddValue(const ompl::base::StateSpace& space, const ompl::base::State* state);

/// Whether the goal is made up of states, which may become more, rather than a region of which states are samples.
[[nodiscard]] bool isMadeOfStates(const ompl::base::Goal& goal);
}  // namespace specplan::planner
