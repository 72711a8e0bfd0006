// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "specplan/lattice/CheckId.h"

namespace specplan::validity
{
/// Where the broker asks for checks to run ahead of demand. Implemented by the speculation policies.
class CheckSource
{
public:
    virtual ~CheckSource() = default;

    /// Appends up to `count` checks that the search may well need, for as long as that takes next to no time.
    virtual void proposeAtHand(std::size_t, std::vector<lattice::CheckId>&)
    {
    }

    /// Appends up to `count` checks that the search is likely to need, most wanted first. Asked only while the search
    /// has to wait and workers are free; no longer if it takes more time than it saves.
    virtual void propose(std::size_t count, std::vector<lattice::CheckId>& out) = 0;

    /// Whether to ask again during a wait, as soon as workers fall free; otherwise once at its beginning.
    [[nodiscard]] virtual bool keepsAsking() const noexcept = 0;

    /// A verdict has come in, wanted or not.
    virtual void learned(lattice::CheckId check, bool valid) = 0;

    /// Verdicts have come in that `learned` was not told of, because checks were too cheap to run ahead.
    virtual void missed()
    {
    }

    /// Whether a check that was proposed and has not started is still of use.
    [[nodiscard]] virtual bool stillWanted(lattice::CheckId) const
    {
        return true;
    }
};
}  // namespace specplan::validity
