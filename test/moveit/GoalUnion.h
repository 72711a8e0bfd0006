// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/util/Exception.h>

namespace specplan::test
{
namespace ob = ompl::base;

/// A look-alike of MoveIt's union of several goal constraints: a region whose samples come from the goals in turn, and
/// come late.
class GoalUnion : public ob::GoalSampleableRegion
{
public:
    using Goals = std::vector<std::shared_ptr<ob::GoalLazySamples>>;

    GoalUnion(const ob::SpaceInformationPtr& si, Goals goals) : ob::GoalSampleableRegion(si), goals_(std::move(goals))
    {
    }

    void sampleGoal(ob::State* state) const override
    {
        for (std::size_t i = 0; i < goals_.size(); ++i)
        {
            const auto& goal = goals_[next_];
            next_ = (next_ + 1) % goals_.size();
            if (goal->maxSampleCount() > 0)
            {
                goal->sampleGoal(state);
                return;
            }
        }
        throw ompl::Exception("There are no states to sample");
    }

    unsigned maxSampleCount() const override
    {
        unsigned count = 0;
        for (const auto& goal : goals_)
            count += goal->maxSampleCount();
        return count;
    }

    bool couldSample() const override
    {
        return std::any_of(goals_.begin(), goals_.end(), [](const auto& goal) { return goal->couldSample(); });
    }

    bool isSatisfied(const ob::State* state, double* distance) const override
    {
        return std::any_of(goals_.begin(), goals_.end(),
                           [&](const auto& goal) { return goal->isSatisfied(state, distance); });
    }

    double distanceGoal(const ob::State* state) const override
    {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& goal : goals_)
            least = std::min(least, goal->distanceGoal(state));
        return least;
    }

private:
    Goals goals_;
    mutable std::size_t next_ = 0;
};
}  // namespace specplan::test
