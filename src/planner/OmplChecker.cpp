// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/OmplChecker.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <string_view>
#include <typeinfo>
#include <utility>

#include <ompl/base/DiscreteMotionValidator.h>

#include "specplan/validity/BrokenOff.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
/// Whether states between two others may be equal to one of them: where values are discrete, or nobody knows what the
/// space does.
bool mayRound(const ob::StateSpace& space)
{
    const bool isOmpls = std::string_view(typeid(space).name()).starts_with("N4ompl");
    if (!isOmpls || space.getType() == ob::STATE_SPACE_DISCRETE)
        return true;
    if (!space.isCompound())
        return false;
    const std::vector<ob::StateSpacePtr>& parts = space.as<ob::CompoundStateSpace>()->getSubspaces();
    return std::ranges::any_of(parts, [](const ob::StateSpacePtr& part) { return mayRound(*part); });
}
}  // namespace

bool isDiscreteMotionValidator(const ob::MotionValidator& validator)
{
    // Those for cars go by other names and headers from version to version.
    const std::string_view name(typeid(validator).name());
    const bool forCars = name.starts_with("N4ompl4base") && (name.find("DubinsMotionValidator") != name.npos ||
                                                             name.find("ReedsSheppMotionValidator") != name.npos);
    return forCars || typeid(validator) == typeid(ob::DiscreteMotionValidator);
}

OmplChecker::OmplChecker(const ob::SpaceInformation& si, unsigned workers) : si_(si), scratch_(workers)
{
}

void OmplChecker::open(const lattice::Lattice& lattice, const Embedding& embedding, Sources sources,
                       ObjectiveCosts* costs)
{
    lattice_ = &lattice;
    embedding_ = &embedding;
    costs_ = costs;
    sources_ = std::move(sources);
    discrete_ = isDiscreteMotionValidator(*sources_.motionValidators.front());
    rounds_ = mayRound(*si_.getStateSpace());
    costsAlone_ = costs != nullptr && sources_.checkers.size() > 1 && !costs->asksNoChecker();
    const std::lock_guard lock(glancesMutex_);
    glanced_.clear();
}

bool OmplChecker::check(validity::CheckId check, unsigned worker)
{
    scratch_[worker].states = 1;
    return check.isMotion() ? checkMotion(check.motion(), worker) : checkState(check.node(), worker);
}

const ob::StateValidityChecker& OmplChecker::checkerOf(unsigned worker) const noexcept
{
    return *sources_.checkers[worker < sources_.checkers.size() ? worker : 0];
}

bool OmplChecker::checkState(lattice::NodeId node, unsigned worker)
{
    const StateHandle state(si_);
    embedding_->write(*lattice_, node, state.get());
    return checkerOf(worker).isValid(state.get());
}

bool OmplChecker::checkMotion(lattice::MotionId id, unsigned worker)
{
    const lattice::Lattice::Motion& motion = lattice_->motion(id);
    const StateHandle from(si_);
    const StateHandle to(si_);
    embedding_->write(*lattice_, motion.from, from.get());
    embedding_->write(*lattice_, motion.to, to.get());
    if (lattice_->isGlance(id))
        return checkGlance(id, from.get(), to.get(), worker);
    const bool valid = discrete_ ? checkInside(from.get(), to.get(), worker, seenOf(id), kAllStates)
                                 : askValidator(from.get(), to.get(), worker);
    if (valid && costs_ != nullptr)
        evaluateCost(id, from.get(), to.get(), worker);
    return valid;
}

bool OmplChecker::checkGlance(lattice::MotionId glance, const ob::State* from, const ob::State* to, unsigned worker)
{
    if (!checkInside(from, to, worker, 0, kGlanceStates))
        return false;
    const std::lock_guard lock(glancesMutex_);
    glanced_.insert(lattice_->glancedAt(glance));
    return true;
}

/// Inner states of a motion that its glance has seen to be valid: the first ones to be looked at.
std::uint32_t OmplChecker::seenOf(lattice::MotionId motion)
{
    if (!lattice_->hasGlances())
        return 0;
    const std::lock_guard lock(glancesMutex_);
    return glanced_.contains(motion) ? kGlanceStates : 0;
}

void OmplChecker::breakOffIfTold(unsigned worker)
{
    if (stop_ != nullptr && stop_->isSetInside(scratch_[worker].look))
        throw validity::BrokenOff();
}

/// Takes a lock that others may hold for long, and goes on looking at the stop signal meanwhile: the search thread has
/// to ask whether to stop. Who holds the lock never waits for that, or the search thread might wait for the lock.
void OmplChecker::waitFor(std::unique_lock<std::timed_mutex>& lock, unsigned worker)
{
    constexpr std::chrono::milliseconds kPatience{1};
    while (!lock.try_lock_for(kPatience))
        breakOffIfTold(worker);
    if (stop_ != nullptr && stop_->isSet())
        throw validity::BrokenOff();
}

void OmplChecker::evaluateCost(lattice::MotionId motion, const ob::State* from, const ob::State* to, unsigned worker)
{
    std::unique_lock lock(sharedObjective_, std::defer_lock);
    if (costsAlone_)
        waitFor(lock, worker);
    costs_->evaluate(motion, from, to);
    scratch_[worker].states = std::max(scratch_[worker].states, 1U);
}

bool OmplChecker::askValidator(const ob::State* from, const ob::State* to, unsigned worker)
{
    scratch_[worker].states = si_.getStateSpace()->validSegmentCount(from, to);
    if (sources_.motionValidators.size() > 1)
        return sources_.motionValidators[worker]->checkMotion(from, to);
    std::unique_lock lock(sharedValidator_, std::defer_lock);
    waitFor(lock, worker);
    return sources_.motionValidators.front()->checkMotion(from, to);
}

/// Whether an inner state is equal to one on either side of its gap.
bool OmplChecker::isBeside(const ob::State* state, const ob::State* from, const ob::State* to, double segments,
                           Gap gap) const
{
    const ob::StateSpace& space = *si_.getStateSpace();
    const StateHandle other(si_);
    for (const unsigned place : {gap.first - 1, gap.last + 1})
    {
        space.interpolate(from, to, static_cast<double>(place) / segments, other.get());
        if (space.equalStates(state, other.get()))
            return true;
    }
    return false;
}

/// \param seen so many of the first inner states are known to be valid. \param most of the inner states to look at:
/// those first that lie farthest from all looked at before.
bool OmplChecker::checkInside(const ob::State* from, const ob::State* to, unsigned worker, std::uint32_t seen,
                              std::uint32_t most)
{
    const ob::StateSpace& space = *si_.getStateSpace();
    const unsigned segments = embedding_->segments(from, to);
    std::uint32_t looked = 0;
    std::deque<Gap> gaps;
    if (segments > 1)
        gaps.push_back({1U, segments - 1});
    bool valid = true;
    while (valid && looked < most && !gaps.empty())
    {
        const Gap gap = gaps.front();
        gaps.pop_front();
        const unsigned middle = gap.first + (gap.last - gap.first) / 2;
        const StateHandle state(si_);
        space.interpolate(from, to, static_cast<double>(middle) / static_cast<double>(segments), state.get());
        valid = !embedding_->curves() || space.satisfiesBounds(state.get());
        if (valid && !(rounds_ && isBeside(state.get(), from, to, segments, gap)) && looked++ >= seen)
        {
            if (looked > seen + 1)
                breakOffIfTold(worker);
            valid = checkerOf(worker).isValid(state.get());
        }
        if (gap.first < middle)
            gaps.push_back({gap.first, middle - 1});
        if (middle < gap.last)
            gaps.push_back({middle + 1, gap.last});
    }
    scratch_[worker].states = looked - std::min(looked, seen);
    return valid;
}
}  // namespace specplan::planner
