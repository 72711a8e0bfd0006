// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/QueryInputs.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/Console.h>

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
/// So many states that cannot be used are told of aloud.
constexpr std::size_t kWarnings = 3;

/// Whether two weak pointers stand for the same object, also if that object is gone.
template <typename T>
bool sameObject(const std::weak_ptr<const T>& a, const std::weak_ptr<const T>& b)
{
    return !a.owner_before(b) && !b.owner_before(a);
}

/// A value is told by what it is, so that one that is not a number equals itself.
bool sameValue(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool sameState(const ob::StateSpace& space, const ob::State* a, const ob::State* b)
{
    std::vector<double> ofA;
    std::vector<double> ofB;
    space.copyToReals(ofA, a);
    space.copyToReals(ofB, b);
    return ofA.empty() ? space.equalStates(a, b) : std::ranges::equal(ofA, ofB, sameValue);
}

std::size_t countOf(const ob::Goal& goal)
{
    if (goal.hasType(ob::GOAL_STATES))
        return goal.as<ob::GoalStates>()->getStateCount();
    return goal.hasType(ob::GOAL_STATE) && goal.as<ob::GoalState>()->getState() != nullptr ? 1 : 0;
}

const ob::State* stateOf(const ob::Goal& goal, std::size_t i)
{
    return goal.hasType(ob::GOAL_STATES) ? goal.as<ob::GoalStates>()->getState(static_cast<unsigned>(i))
                                         : goal.as<ob::GoalState>()->getState();
}

/// How many goal states can be had. States are counted themselves: those of a GoalState may not be set.
std::size_t mostOf(const ob::GoalSampleableRegion& goal)
{
    return isMadeOfStates(goal) ? countOf(goal) : goal.maxSampleCount();
}

double thresholdOf(const ob::Goal& goal)
{
    return goal.hasType(ob::GOAL_REGION) ? goal.as<ob::GoalRegion>()->getThreshold() : 0.0;
}
}  // namespace

std::string oddValue(const ob::StateSpace& space, const ob::State* state)
{
    std::vector<double> values;
    space.copyToReals(values, state);
    const auto odd = std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
    if (odd == values.end())
        return "";
    return "value " + std::to_string(odd - values.begin()) + " is " + std::to_string(*odd) + ", not a finite number";
}

bool isMadeOfStates(const ob::Goal& goal)
{
    return goal.hasType(ob::GOAL_STATE) || goal.hasType(ob::GOAL_STATES);
}

QueryInputs::QueryInputs(const ob::SpaceInformation& si) : si_(si), sample_(si)
{
}

bool QueryInputs::continues(const ob::ProblemDefinitionPtr& pdef) const
{
    return sameObject<ob::ProblemDefinition>(pdef_, pdef) && sameObject<ob::Goal>(goal_, pdef->getGoal()) &&
           sameStarts(*pdef) && sameGoals(*pdef->getGoal());
}

bool QueryInputs::sameStarts(const ob::ProblemDefinition& pdef) const
{
    if (pdef.getStartStateCount() < starts_.size())
        return false;
    for (std::size_t i = 0; i < starts_.size(); ++i)
        if (!sameState(*si_.getStateSpace(), starts_[i].get(), pdef.getStartState(static_cast<unsigned>(i))))
            return false;
    return true;
}

bool QueryInputs::sameGoals(const ob::Goal& goal) const
{
    if (thresholdOf(goal) != threshold_ || countOf(goal) < goals_.size())
        return false;
    for (std::size_t i = 0; i < goals_.size(); ++i)
        if (!sameState(*si_.getStateSpace(), goals_[i].get(), stateOf(goal, i)))
            return false;
    return true;
}

void QueryInputs::open(const ob::ProblemDefinitionPtr& pdef)
{
    close();
    pdef_ = pdef;
    goal_ = pdef->getGoal();
    threshold_ = thresholdOf(*pdef->getGoal());
    rememberGoals();
    if (const ob::GoalSampleableRegion* goal = sampleable())
        mostGoals_ = mostOf(*goal);
}

void QueryInputs::close()
{
    pdef_.reset();
    goal_.reset();
    starts_.clear();
    goals_.clear();
    goalsSeen_ = 0;
    mostGoals_ = 0;
    growing_ = false;
    checksRun_ = 0;
}

const ob::GoalSampleableRegion* QueryInputs::sampleable() const
{
    const std::shared_ptr<const ob::Goal> goal = goal_.lock();
    return goal && goal->hasType(ob::GOAL_SAMPLEABLE_REGION) ? goal->as<ob::GoalSampleableRegion>() : nullptr;
}

void QueryInputs::rememberGoals()
{
    const std::shared_ptr<const ob::Goal> goal = goal_.lock();
    if (!goal || !isMadeOfStates(*goal))
        return;
    for (std::size_t i = goals_.size(), n = countOf(*goal); i < n; ++i)
        goals_.emplace_back(si_, stateOf(*goal, i));
}

bool QueryInputs::isUsable(const ob::State* state, const char* kind, std::size_t number)
{
    std::string reason = oddValue(*si_.getStateSpace(), state);
    if (!reason.empty())
        reason = "its " + reason;
    else if (!si_.satisfiesBounds(state))
        reason = "it is outside the bounds";
    else
    {
        ++checksRun_;
        if (si_.isValid(StateHandle(si_, state).get()))  // a copy, should the checker write into it
            return true;
        reason = "it is not valid";
    }
    const auto level = number < kWarnings ? ompl::msg::LOG_WARN : ompl::msg::LOG_DEBUG;
    ompl::msg::log(__FILE__, __LINE__, level, "SpeculativeAStar: %s state %lu is left out: %s", kind,
                   static_cast<unsigned long>(number), reason.c_str());
    return false;
}

const ob::State* QueryInputs::nextStart(const ob::PlannerTerminationCondition& ptc)
{
    const std::shared_ptr<const ob::ProblemDefinition> pdef = pdef_.lock();
    while (hasStart() && (checksRun_ == 0 || !ptc()))
    {
        const std::size_t number = starts_.size();
        const ob::State* state = pdef->getStartState(static_cast<unsigned>(number));
        const bool usable = isUsable(state, "start", number);
        starts_.emplace_back(si_, state);
        if (usable)
            return state;
    }
    return nullptr;
}

bool QueryInputs::hasStart() const
{
    const std::shared_ptr<const ob::ProblemDefinition> pdef = pdef_.lock();
    return pdef && starts_.size() < pdef->getStartStateCount();
}

const ob::State* QueryInputs::nextGoal(const ob::PlannerTerminationCondition& ptc)
{
    rememberGoals();
    while (hasGoal() && !ptc())
    {
        const ob::GoalSampleableRegion& goal = *sampleable();
        if (isMadeOfStates(goal))  // sampleGoal() would move on a mark that planners share
            si_.copyState(sample_.get(), stateOf(goal, goalsSeen_));
        else
            goal.sampleGoal(sample_.get());
        if (isUsable(sample_.get(), "goal", goalsSeen_++))
            return sample_.get();
    }
    return nullptr;
}

bool QueryInputs::hasGoal() const
{
    const ob::GoalSampleableRegion* goal = sampleable();
    if (goal == nullptr)
        return false;
    const std::size_t most = mostOf(*goal);
    growing_ = growing_ || most > mostGoals_;
    mostGoals_ = std::max(mostGoals_, most);
    return goalsSeen_ < most;
}

bool QueryInputs::mayGetGoals() const
{
    const ob::GoalSampleableRegion* goal = sampleable();
    if (goal == nullptr || hasGoal())
        return false;
    if (goal->hasType(ob::GOAL_LAZY_SAMPLES))
        return goal->as<ob::GoalLazySamples>()->isSampling();
    if (isMadeOfStates(*goal) || !goal->couldSample())
        return false;
    // A region of which all samples were had says that it could be sampled, too: more are to be expected only if some
    // came late before, or none could be had yet.
    growing_ = growing_ || !goal->canSample();
    return growing_;
}
}  // namespace specplan::planner
