// SPDX-License-Identifier: BSD-3-Clause
#include "DescribedAxes.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include <ompl/util/Exception.h>

#include "RoundingSlack.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
std::string naming(const LatticeAxes& described, const LatticeAxis& axis)
{
    std::string name = "axis '" + axis.name + "'";
    if (!described.space.empty())
        name += " of the space '" + described.space + "'";
    return name;
}

/// Values of copyToReals() for each axis; the others stay those of the origin.
AxesComponent::Access accessThroughValues(const ob::StateSpacePtr& space, const LatticeAxes& described,
                                          const std::vector<double>& origin)
{
    std::vector<std::size_t> numbers;
    for (const LatticeAxis& axis : described.axes)
        numbers.push_back(static_cast<std::size_t>(axis.value));
    AxesComponent::Access access;
    access.read = [space, numbers](const ob::State* state, double* values)
    {
        std::vector<double> reals;
        space->copyToReals(reals, state);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            values[i] = reals[numbers[i]];
    };
    access.write = [space, numbers, origin](const double* values, ob::State* state)
    {
        std::vector<double> reals = origin;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            reals[numbers[i]] = values[i];
        space->copyFromReals(state, reals);
    };
    return access;
}
}  // namespace

void validate(const LatticeAxes& described)
{
    if (static_cast<bool>(described.read) != static_cast<bool>(described.write))
        throw std::invalid_argument("lattice axes need both 'read' and 'write', or neither");
    for (std::size_t i = 0; i < described.axes.size(); ++i)
    {
        const LatticeAxis& axis = described.axes[i];
        const std::string name = naming(described, axis);
        if (!std::isfinite(axis.lower) || !std::isfinite(axis.upper) || axis.lower > axis.upper ||
            (axis.wraps && axis.lower == axis.upper))
        {
            std::ostringstream message;
            message << name << " must have finite bounds, the lower one " << (axis.wraps ? "less" : "not greater")
                    << " than the upper one, not " << axis.lower << " and " << axis.upper;
            throw std::invalid_argument(message.str());
        }
        if (described.write)
            continue;
        if (axis.value < 0)
            throw std::invalid_argument(name +
                                        " needs 'value', its number among the values of copyToReals(), where "
                                        "there are no 'read' and 'write'");
        for (std::size_t k = 0; k < i; ++k)
            if (described.axes[k].value == axis.value)
                throw std::invalid_argument(name + " has the same value, number " + std::to_string(axis.value) +
                                            ", as axis '" + described.axes[k].name + "'");
    }
}

void draftDescribed(const ob::StateSpacePtr& space, const LatticeAxes& described, const ob::State* origin,
                    std::vector<RealAxis>& axes, AxesComponent::Access& access)
{
    std::vector<double> reals;
    space->copyToReals(reals, origin);
    for (const LatticeAxis& axis : described.axes)
    {
        if (!described.write && static_cast<std::size_t>(axis.value) >= reals.size())
            throw ompl::Exception(naming(described, axis) + " is said to be value " + std::to_string(axis.value) +
                                  " of copyToReals(), but the space '" + space->getName() + "' has only " +
                                  std::to_string(reals.size()));
        axes.push_back({axis.name, axis.lower, axis.upper, axis.wraps, 0.0, axis.whole ? 1.0 : 0.0, axis.whole});
    }
    if (described.write)
        access = {described.read, described.write};
    else
        access = accessThroughValues(space, described, reals);
    std::vector<double> start(axes.size());
    access.read(origin, start.data());
    for (std::size_t i = 0; i < axes.size(); ++i)
    {
        const double slack = kRoundingSlack * (axes[i].upper - axes[i].lower);
        if (!(start[i] >= axes[i].lower - slack && start[i] <= axes[i].upper + slack))
        {
            std::ostringstream message;
            message << naming(described, described.axes[i]) << " goes from " << axes[i].lower << " to " << axes[i].upper
                    << ", but the start has " << start[i];
            throw ompl::Exception(message.str());
        }
    }
}
}  // namespace specplan::planner
