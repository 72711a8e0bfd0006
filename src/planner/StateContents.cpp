// SPDX-License-Identifier: BSD-3-Clause
#include "StateContents.h"

#include <cstring>

namespace specplan::planner
{
namespace ob = ompl::base;

StateContents::StateContents(const ob::StateSpace& space, const ob::State* state)
{
    space.copyToReals(values_, state);
    bytes_.resize(space.getSerializationLength());
    if (!bytes_.empty())
        space.serialize(bytes_.data(), state);
}

StateContents::Change StateContents::changeTo(const StateContents& other) const
{
    // Bit by bit: a NaN equals itself here.
    const std::size_t size = values_.size() * sizeof(double);
    if (size != 0 && std::memcmp(values_.data(), other.values_.data(), size) != 0)
        return Change::Values;
    return bytes_ == other.bytes_ ? Change::None : Change::BesideValues;
}
}  // namespace specplan::planner
