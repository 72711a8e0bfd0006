// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/PathProof.h"

#include <algorithm>
#include <utility>

#include <ompl/util/Exception.h>

#include "specplan/planner/OmplChecker.h"
#include "specplan/planner/StateHandle.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
std::string remedy(const ob::SpaceInformation& si)
{
    return ": the class of '" + si.getStateSpace()->getName() +
           "' keeps more in a state than the values that the planner writes; fill it in with "
           "SpeculativeAStar::setStateCompleter";
}
}  // namespace

PathProof::PathProof(const ob::SpaceInformation& si, Path path)
    : si_(si), path_(std::move(path)), discrete_(isDiscreteMotionValidator(*si.getMotionValidator()))
{
}

bool PathProof::run(const std::function<bool()>& stop)
{
    while (fault_.empty() && state_ < path_->getStateCount())
    {
        if (stop())
            return false;
        ++checks_;
        const std::size_t number = state_ + 1;
        const bool inside = inner_ > 0;
        if (checkNext())
            continue;
        fault_ = (inside ? "the motion to state " : "state ") + std::to_string(number) + " of the " +
                 std::to_string(path_->getStateCount()) +
                 " of the path found is not valid, though the search found it valid" + remedy(si_) +
                 " (or the checker's answers change)";
    }
    return true;
}

/// Checks one more state, or motion, and moves on. The user's code gets copies: the path stays what it is, should that
/// write into them.
bool PathProof::checkNext()
{
    const ob::State* to = path_->getState(static_cast<unsigned>(state_));
    const ob::State* from = state_ > 0 ? path_->getState(static_cast<unsigned>(state_ - 1)) : nullptr;
    const unsigned segments =
        from == nullptr ? 1U : (discrete_ ? si_.getStateSpace()->validSegmentCount(from, to) : 2U);
    bool valid = false;
    if (inner_ == 0)
        valid = si_.isValid(StateHandle(si_, to).get());
    else if (discrete_)
    {
        const StateHandle state(si_);
        si_.getStateSpace()->interpolate(from, to, static_cast<double>(inner_) / segments, state.get());
        valid = si_.isValid(state.get());
    }
    else
        valid = si_.checkMotion(StateHandle(si_, from).get(), StateHandle(si_, to).get());
    if (++inner_ >= segments)
    {
        inner_ = 0;
        ++state_;
    }
    return valid;
}

void requireComplete(const ob::SpaceInformation& si, const ob::State* written, const ob::State* valid)
{
    const StateHandle copy(si, written);
    const StateHandle between(si);
    si.getStateSpace()->interpolate(valid, written, 0.5, between.get());
    if (!si.isValid(copy.get()) || !si.isValid(between.get()))
        throw ompl::Exception("a state written with the start's values is not valid, though the start is" + remedy(si));
}
}  // namespace specplan::planner
