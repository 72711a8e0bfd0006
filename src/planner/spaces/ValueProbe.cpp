// SPDX-License-Identifier: BSD-3-Clause
#include "ValueProbe.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
/// Small moves, no two of them alike, that no sensible unit makes a whole turn.
constexpr std::array<double, 4> kMoves{0.1, -0.07, 0.013, -0.029};
/// Moves that leave any bounds, or nearly.
constexpr std::array<double, 6> kFarMoves{0.5, -0.5, 3.0, -3.0, 1e6, -1e6};
constexpr double kSame = 1e-9;

bool same(double a, double b)
{
    return std::abs(a - b) <= kSame * std::max({1.0, std::abs(a), std::abs(b)});
}
}  // namespace

ValueProbe::ValueProbe(const ob::StateSpacePtr& space, const ob::State* origin) : space_(space), state_(space)
{
    space_->copyToReals(origin_, origin);
}

void ValueProbe::fill(const ob::StateSpace& space, ob::State* state, Filling filling)
{
    if (filling == Filling::Bounds)
        space.enforceBounds(state);
    else if (filling == Filling::Interpolation)
        space.interpolate(state, state, 0.5, state);  // OMPL allows one state in all places
}

ValueProbe::Values ValueProbe::filled(std::size_t value, double to, Filling filling)
{
    Values values = origin_;
    values[value] = to;
    space_->copyFromReals(state_.get(), values);
    fill(*space_, state_.get(), filling);
    space_->copyToReals(values, state_.get());
    return values;
}

ValueProbe::Filling ValueProbe::fillingOf(std::size_t value)
{
    for (const Filling filling : {Filling::Bounds, Filling::Interpolation})
        if (overwrites(value, filling) && followsOthers(value, filling))
            return filling;
    return Filling::None;
}

/// Whether the value becomes the same whatever it was.
bool ValueProbe::overwrites(std::size_t value, Filling filling)
{
    const double first = filled(value, origin_[value] + kMoves.front(), filling)[value];
    for (const double move : kMoves)
    {
        const double moved = origin_[value] + move;
        const double found = filled(value, moved, filling)[value];
        if (same(found, moved) || !same(found, first))
            return false;
    }
    return true;
}

/// Whether moving another value moves this one, while that other one stays where it was moved to.
bool ValueProbe::followsOthers(std::size_t value, Filling filling)
{
    const double rest = filled(value, origin_[value], filling)[value];
    for (std::size_t other = 0; other < origin_.size(); ++other)
        for (const double move : kMoves)
        {
            if (other == value)
                continue;
            const double moved = origin_[other] + move;
            const Values found = filled(other, moved, filling);
            if (same(found[other], moved) && !same(found[value], rest))
                return true;
        }
    return false;
}

std::optional<std::size_t> ValueProbe::changesWith(std::size_t value, const std::vector<bool>& filled)
{
    const Values rest = enforced(value, origin_[value]);
    for (const double move : kFarMoves)
    {
        const Values found = enforced(value, origin_[value] + move);
        for (std::size_t other = 0; other < found.size(); ++other)
            if (other != value && !filled[other] && !same(found[other], rest[other]))
                return other;
    }
    return std::nullopt;
}
}  // namespace specplan::planner
