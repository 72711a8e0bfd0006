// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/OmplChecker.h"

#include <deque>
#include <typeinfo>
#include <utility>

#include <ompl/base/DiscreteMotionValidator.h>

namespace specplan::planner
{
namespace ob = ompl::base;

bool isDiscreteMotionValidator(const ob::MotionValidator& validator)
{
    return typeid(validator) == typeid(ob::DiscreteMotionValidator);
}

OmplChecker::OmplChecker(const ob::SpaceInformation& si, unsigned workers) : si_(si), scratch_(workers)
{
}

void OmplChecker::open(const lattice::Lattice& lattice, const RealVectorEmbedding& embedding, Sources sources)
{
    lattice_ = &lattice;
    embedding_ = &embedding;
    sources_ = std::move(sources);
    discrete_ = isDiscreteMotionValidator(*sources_.motionValidators.front());
}

bool OmplChecker::check(validity::CheckId check, unsigned worker)
{
    scratch_[worker].states = 1;
    return check.isMotion() ? checkMotion(lattice_->motion(check.motion()), worker) : checkState(check.node(), worker);
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

bool OmplChecker::checkMotion(const lattice::Lattice::Motion& motion, unsigned worker)
{
    const StateHandle from(si_);
    const StateHandle to(si_);
    embedding_->write(*lattice_, motion.from, from.get());
    embedding_->write(*lattice_, motion.to, to.get());
    if (discrete_)
        return checkInside(from.get(), to.get(), worker);
    scratch_[worker].states = si_.getStateSpace()->validSegmentCount(from.get(), to.get());
    if (sources_.motionValidators.size() > 1)
        return sources_.motionValidators[worker]->checkMotion(from.get(), to.get());
    const std::lock_guard lock(sharedValidator_);
    return sources_.motionValidators.front()->checkMotion(from.get(), to.get());
}

bool OmplChecker::checkInside(const ob::State* from, const ob::State* to, unsigned worker)
{
    const ob::StateSpace& space = *si_.getStateSpace();
    const unsigned segments = space.validSegmentCount(from, to);
    std::uint32_t looked = 0;
    std::deque<std::pair<unsigned, unsigned>> open;  // unchecked inner states [first, last], the middle one first
    if (segments > 1)
        open.emplace_back(1U, segments - 1);
    bool valid = true;
    while (valid && !open.empty())
    {
        const auto [first, last] = open.front();
        open.pop_front();
        const unsigned middle = first + (last - first) / 2;
        const StateHandle state(si_);
        space.interpolate(from, to, static_cast<double>(middle) / static_cast<double>(segments), state.get());
        valid = checkerOf(worker).isValid(state.get());
        ++looked;
        if (first < middle)
            open.emplace_back(first, middle - 1);
        if (middle < last)
            open.emplace_back(middle + 1, last);
    }
    scratch_[worker].states = looked;
    return valid;
}
}  // namespace specplan::planner
