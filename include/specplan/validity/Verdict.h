// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace specplan::validity
{
/// What is known of one check.
enum class Verdict : std::uint8_t
{
    Unknown,   ///< nothing asked yet
    InFlight,  ///< handed to the executor, not back yet
    Valid,
    Invalid
};

[[nodiscard]] constexpr bool isKnown(Verdict verdict) noexcept
{
    return verdict == Verdict::Valid || verdict == Verdict::Invalid;
}
}  // namespace specplan::validity
