// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/lattice/CheckId.h"

namespace specplan::lattice
{
/// Costs of motions that only a check of the motion tells: an objective that looks at every state on the way costs as
/// much as a check, so it is evaluated by the check.
class MotionCosts
{
public:
    virtual ~MotionCosts() = default;

    /// Motions below this number are about to be checked; search thread.
    virtual void makeRoom(std::size_t motions) = 0;

    /// A cost that the motion has at least; cheap, search thread.
    [[nodiscard]] virtual double lowerBound(NodeId from, NodeId to) const = 0;

    /// The cost of a motion whose check has said that it is valid; search thread.
    [[nodiscard]] virtual double known(MotionId motion) const = 0;
};
}  // namespace specplan::lattice
