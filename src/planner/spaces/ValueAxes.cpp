// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/ValueAxes.h"

#include <cmath>
#include <numbers>
#include <string>

#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Where enforceBounds() puts a value.
class Prober
{
public:
    Prober(const ob::StateSpacePtr& space, const ob::State* origin) : space_(space), state_(space)
    {
        space_->copyToReals(values_, origin);
    }

    [[nodiscard]] double enforced(std::size_t axis, double value)
    {
        std::vector<double> moved = values_;
        moved[axis] = value;
        space_->copyFromReals(state_.get(), moved);
        space_->enforceBounds(state_.get());
        std::vector<double> found;
        space_->copyToReals(found, state_.get());
        return found[axis];
    }

    [[nodiscard]] const std::vector<double>& origin() const noexcept
    {
        return values_;
    }

private:
    const ob::StateSpacePtr& space_;
    ob::ScopedState<> state_;
    std::vector<double> values_;
};

RealAxis probe(Prober& prober, std::size_t axis, const std::string& space)
{
    const std::string name = "value " + std::to_string(axis);
    constexpr double kFar = 1e6;
    const double low = prober.enforced(axis, -kFar);
    const double high = prober.enforced(axis, kFar);
    const double lower = prober.enforced(axis, -2.0 * kFar);
    const double higher = prober.enforced(axis, 2.0 * kFar);
    if (low == lower && high == higher && low > -kFar && high < kFar)
        return {name, low, high, false, 0.0, 0.0, false};
    const double here = prober.origin()[axis];
    const double round = prober.enforced(axis, here + kTurn);
    const double half = prober.enforced(axis, here + kTurn / 2.0);
    if (std::abs(round - here) < 1e-9 && std::abs(half - here) > 1.0)
        return {name, -std::numbers::pi, std::numbers::pi, true, 0.0, 0.0, false};
    throw ompl::Exception("the state space '" + space + "' has no bounds for its " + name +
                          ": enforceBounds() has to keep every value within bounds, or bring it round by 2 pi");
}
}  // namespace

void draftValues(const ob::StateSpacePtr& space, const ob::State* origin, std::vector<RealAxis>& axes,
                 AxesComponent::Access& access)
{
    Prober prober(space, origin);
    ob::ScopedState<> copy(space);
    space->copyFromReals(copy.get(), prober.origin());
    if (prober.origin().empty() || !space->equalStates(copy.get(), origin))
        throw ompl::Exception("the state space '" + space->getName() +
                              "' is not made up of the values that copyToReals() tells (see "
                              "StateSpace::getValueAddressAtIndex), so there is no lattice over it");
    for (std::size_t axis = 0; axis < prober.origin().size(); ++axis)
        axes.push_back(probe(prober, axis, space->getName()));
    access.read = [space](const ob::State* state, double* values)
    {
        std::vector<double> reals;
        space->copyToReals(reals, state);
        std::copy(reals.begin(), reals.end(), values);
    };
    access.write = [space, n = axes.size()](const double* values, ob::State* state)
    { space->copyFromReals(state, std::vector<double>(values, values + n)); };
}
}  // namespace specplan::planner
