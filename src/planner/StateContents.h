// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/SpaceInformation.h>

namespace specplan::planner
{
/// All that a state space tells of a state, so that a write into the state can be seen: its values, and what
/// StateSpace::serialize() writes besides.
class StateContents
{
public:
    enum class Change
    {
        None,
        BesideValues,
        Values
    };

    StateContents(const ompl::base::StateSpace& space, const ompl::base::State* state);

    /// What has changed from this one to another.
    [[nodiscard]] Change changeTo(const StateContents& other) const;

private:
    std::vector<double> values_;
    std::vector<unsigned char> bytes_;
};
}  // namespace specplan::planner
