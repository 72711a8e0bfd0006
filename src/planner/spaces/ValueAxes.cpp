// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/ValueAxes.h"

#include <cmath>
#include <numbers>
#include <string>

#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>

#include "ValueProbe.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
using Filling = ValueProbe::Filling;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr const char* kDescribe = "describe its axes with SpeculativeAStar::setLatticeAxes";

RealAxis axisOf(ValueProbe& probe, std::size_t value, const std::string& space)
{
    const std::string name = "value " + std::to_string(value);
    constexpr double kFarAway = 1e6;
    const auto enforced = [&](double to) { return probe.enforced(value, to)[value]; };
    const double low = enforced(-kFarAway);
    const double high = enforced(kFarAway);
    if (low == enforced(-2.0 * kFarAway) && high == enforced(2.0 * kFarAway) && low > -kFarAway && high < kFarAway)
        return {name, low, high, false, 0.0, 0.0, false};
    const double here = probe.origin()[value];
    if (std::abs(enforced(here + kTurn) - here) < 1e-9 && std::abs(enforced(here + kTurn / 2.0) - here) > 1.0)
        return {name, -std::numbers::pi, std::numbers::pi, true, 0.0, 0.0, false};
    throw ompl::Exception("the state space '" + space + "' has no bounds for its " + name +
                          ": enforceBounds() has to keep every value within bounds, or bring it round by 2 pi. Give it "
                          "bounds (planar and floating joints in MoveIt: those of the workspace), or " +
                          kDescribe);
}

/// Values that the space fills in by itself, and how.
struct FilledValues
{
    std::vector<bool> are;
    Filling filling = Filling::None;
};

FilledValues findFilled(ValueProbe& probe)
{
    FilledValues filled{std::vector<bool>(probe.origin().size()), Filling::None};
    for (std::size_t value = 0; value < filled.are.size(); ++value)
    {
        const Filling how = probe.fillingOf(value);
        // One way for all: what interpolate() fills in enforceBounds() might not.
        filled.are[value] = how != Filling::None && (filled.filling == Filling::None || filled.filling == how);
        if (filled.are[value])
            filled.filling = how;
    }
    return filled;
}

void refuseTangled(ValueProbe& probe, std::size_t value, const std::vector<bool>& filled, const std::string& space)
{
    if (const auto other = probe.changesWith(value, filled))
        throw ompl::Exception("the state space '" + space +
                              "' has values that depend on each other: enforceBounds() "
                              "changes value " +
                              std::to_string(*other) + " when value " + std::to_string(value) +
                              " is moved, as those of a quaternion; they are no axes of a lattice: " + kDescribe);
}
}  // namespace

void draftValues(const ob::StateSpacePtr& space, const ob::State* origin, std::vector<RealAxis>& axes,
                 AxesComponent::Access& access)
{
    ValueProbe probe(space, origin);
    ob::ScopedState<> copy(space);
    if (!probe.origin().empty())
        space->copyFromReals(copy.get(), probe.origin());
    if (probe.origin().empty() || !space->equalStates(copy.get(), origin))
        throw ompl::Exception("the state space '" + space->getName() +
                              "' is not made up of the values that copyToReals() tells (see "
                              "StateSpace::getValueAddressAtIndex), so there is no lattice over it: " +
                              kDescribe);
    const FilledValues filled = findFilled(probe);
    std::vector<std::size_t> numbers;
    for (std::size_t value = 0; value < probe.origin().size(); ++value)
    {
        if (filled.are[value])
            continue;
        refuseTangled(probe, value, filled.are, space->getName());
        axes.push_back(axisOf(probe, value, space->getName()));
        numbers.push_back(value);
    }
    access.read = [space, numbers](const ob::State* state, double* values)
    {
        std::vector<double> reals;
        space->copyToReals(reals, state);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            values[i] = reals[numbers[i]];
    };
    access.write =
        [space, numbers, reals = probe.origin(), filling = filled.filling](const double* values, ob::State* state)
    {
        std::vector<double> all = reals;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            all[numbers[i]] = values[i];
        space->copyFromReals(state, all);
        ValueProbe::fill(*space, state, filling);
    };
}
}  // namespace specplan::planner
