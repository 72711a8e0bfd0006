// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <utility>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "GroupSpace.h"

namespace specplan::test
{
/// A look-alike of MoveIt's checker: it notes its verdict in the state that it was given, const or not, and takes the
/// note for the verdict when it is given that state, or a copy, again. Counts what it does.
class NotingChecker : public ob::StateValidityChecker
{
public:
    using Truth = std::function<bool(const double* values)>;

    struct Counts
    {
        std::atomic<int> calls{0};
        std::atomic<int> noted{0};    ///< answered from the note in the state
        std::atomic<int> stale{0};    ///< of these, wrong ones
        std::atomic<int> running{0};  ///< calls going on
        std::atomic<int> most{0};     ///< of these at once
    };

    /// \param latency of each check that is not answered from a note.
    NotingChecker(const ob::SpaceInformationPtr& si, Truth truth, Counts& counts,
                  std::chrono::microseconds latency = std::chrono::microseconds(0))
        : ob::StateValidityChecker(si), truth_(std::move(truth)), counts_(counts), latency_(latency)
    {
    }

    bool isValid(const ob::State* state) const override
    {
        ++counts_.calls;
        int most = counts_.most;
        for (const int now = ++counts_.running; now > most && !counts_.most.compare_exchange_weak(most, now);)
        {
        }
        const bool valid = answer(*const_cast<ob::State*>(state)->as<GroupSpace::StateType>());
        --counts_.running;
        return valid;
    }

private:
    [[nodiscard]] bool answer(GroupSpace::StateType& state) const
    {
        const bool valid = si_->satisfiesBounds(&state) && truth_(state.values);
        if ((state.flags & GroupSpace::ValidityKnown) != 0)
        {
            const bool note = (state.flags & GroupSpace::ValidityTrue) != 0;
            ++counts_.noted;
            counts_.stale += note != valid ? 1 : 0;
            return note;
        }
        if (latency_.count() > 0)
            std::this_thread::sleep_for(latency_);
        state.flags |= GroupSpace::ValidityKnown;
        if (valid)
            state.flags |= GroupSpace::ValidityTrue;
        return valid;
    }

    Truth truth_;
    Counts& counts_;
    std::chrono::microseconds latency_;
};
}  // namespace specplan::test
