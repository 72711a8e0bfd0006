// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include <ompl/base/SpaceInformation.h>

namespace specplan::planner
{
/// Owns one OMPL state.
class StateHandle
{
public:
    /// A fresh state with unspecified values.
    explicit StateHandle(const ompl::base::SpaceInformation& si) : si_(&si), state_(si.allocState())
    {
    }

    /// A copy of `state`.
    StateHandle(const ompl::base::SpaceInformation& si, const ompl::base::State* state)
        : si_(&si), state_(si.cloneState(state))
    {
    }

    StateHandle(StateHandle&& other) noexcept : si_(other.si_), state_(std::exchange(other.state_, nullptr))
    {
    }

    StateHandle& operator=(StateHandle&& other) noexcept
    {
        std::swap(si_, other.si_);
        std::swap(state_, other.state_);
        return *this;
    }

    ~StateHandle()
    {
        if (state_ != nullptr)
            si_->freeState(state_);
    }

    [[nodiscard]] ompl::base::State* get() const noexcept
    {
        return state_;
    }

private:
    const ompl::base::SpaceInformation* si_;
    ompl::base::State* state_;
};
}  // namespace specplan::planner
