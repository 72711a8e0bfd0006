// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/OmplChecker.h"

#include <algorithm>
#include <deque>
#include <string_view>
#include <typeinfo>
#include <utility>

#include <ompl/base/DiscreteMotionValidator.h>

namespace specplan::planner
{
namespace ob = ompl::base;

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
        return checkInside(from.get(), to.get(), worker, kGlanceStates);
    const bool valid =
        discrete_ ? checkInside(from.get(), to.get(), worker, kAllStates) : askValidator(from.get(), to.get(), worker);
    if (valid && costs_ != nullptr)
    {
        costs_->evaluate(id, from.get(), to.get());
        scratch_[worker].states = std::max(scratch_[worker].states, 1U);
    }
    return valid;
}

bool OmplChecker::askValidator(const ob::State* from, const ob::State* to, unsigned worker)
{
    scratch_[worker].states = si_.getStateSpace()->validSegmentCount(from, to);
    if (sources_.motionValidators.size() > 1)
        return sources_.motionValidators[worker]->checkMotion(from, to);
    const std::lock_guard lock(sharedValidator_);
    return sources_.motionValidators.front()->checkMotion(from, to);
}

/// \param most of the inner states to look at, those first that lie farthest from all looked at before.
bool OmplChecker::checkInside(const ob::State* from, const ob::State* to, unsigned worker, std::uint32_t most)
{
    const ob::StateSpace& space = *si_.getStateSpace();
    const unsigned segments = embedding_->segments(from, to);
    std::uint32_t looked = 0;
    std::deque<std::pair<unsigned, unsigned>> open;  // unchecked inner states [first, last], the middle one first
    if (segments > 1)
        open.emplace_back(1U, segments - 1);
    bool valid = true;
    while (valid && looked < most && !open.empty())
    {
        const auto [first, last] = open.front();
        open.pop_front();
        const unsigned middle = first + (last - first) / 2;
        const StateHandle state(si_);
        space.interpolate(from, to, static_cast<double>(middle) / static_cast<double>(segments), state.get());
        valid = !embedding_->curves() || space.satisfiesBounds(state.get());
        if (valid)
        {
            valid = checkerOf(worker).isValid(state.get());
            ++looked;
        }
        if (first < middle)
            open.emplace_back(first, middle - 1);
        if (middle < last)
            open.emplace_back(middle + 1, last);
    }
    scratch_[worker].states = looked;
    return valid;
}
}  // namespace specplan::planner
