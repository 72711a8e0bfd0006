// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "specplan/lattice/CheckId.h"
#include "specplan/util/PagedTable.h"
#include "specplan/validity/Verdict.h"

namespace specplan::validity
{
/// What is known of every check, states and motions in tables of their own so that neither can stand for the other.
///
/// Threads: search thread only. Workers report through the executor.
class VerdictTable
{
public:
    struct Entry
    {
        Verdict verdict = Verdict::Unknown;
        bool speculative : 1 = false;  ///< was run ahead of demand
        bool thoughtOf : 1 = false;    ///< the source had to think to name it
        bool handedOver : 1 = false;   ///< to another thread, which runs it or has run it
        bool awaited : 1 = false;      ///< the search is waiting for it right now
        bool failed : 1 = false;       ///< the check threw; the verdict stays Unknown
        bool reported : 1 = false;     ///< what it threw has been passed on
        std::uint16_t usedIn = 0;      ///< last query whose search has asked for it; 0: none
        std::uint16_t foundIn = 0;     ///< query in which the verdict came in
        float seconds = 0.0F;          ///< duration of the check
    };

    /// The entry of a check, made on first touch.
    [[nodiscard]] Entry& operator[](lattice::CheckId check)
    {
        return check.isMotion() ? motions_[check.motion()] : states_[check.node()];
    }

    [[nodiscard]] Verdict verdict(lattice::CheckId check) const noexcept
    {
        const Entry* entry = find(check);
        return entry != nullptr ? entry->verdict : Verdict::Unknown;
    }

    /// Last query whose search has asked for the verdict; 0: none.
    [[nodiscard]] std::uint16_t usedIn(lattice::CheckId check) const noexcept
    {
        const Entry* entry = find(check);
        return entry != nullptr ? entry->usedIn : 0;
    }

private:
    [[nodiscard]] const Entry* find(lattice::CheckId check) const noexcept
    {
        return check.isMotion() ? motions_.find(check.motion()) : states_.find(check.node());
    }

    util::PagedTable<Entry> states_;
    util::PagedTable<Entry> motions_;
};
}  // namespace specplan::validity
