// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/lattice/CheckId.h"

namespace specplan::validity
{
using lattice::CheckId;

/// The expensive part: decides whether a state, or the inside of a motion, is valid.
class Checker
{
public:
    virtual ~Checker() = default;

    /// Runs one check. May throw; the exception reaches the search only if the search needs this check. \throws
    /// BrokenOff if a StopSignal said so: there is no verdict then.
    ///
    /// Threads: called by several at once, each with its own `worker` number, below the executor's `workers()`.
    virtual bool check(CheckId check, unsigned worker) = 0;

    /// Whether checks of motions look at the StopSignal between the states that they look at.
    [[nodiscard]] virtual bool stopsInside() const noexcept
    {
        return false;
    }
};
}  // namespace specplan::validity
