// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace specplan::util
{
/// Mixes `value` into `seed`: the 64-bit finaliser of MurmurHash3 over their combination.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t seed, std::uint64_t value) noexcept
{
    std::uint64_t x = seed ^ (value + 0x9e3779b97f4a7c15ULL + (seed << 6) + (seed >> 2));
    x ^= x >> 33;
    x *= 0xff51afd7ed558ccdULL;
    x ^= x >> 33;
    x *= 0xc4ceb9fe1a85ec53ULL;
    return x ^ (x >> 33);
}

/// Hash of lattice coordinates; the same on every platform.
[[nodiscard]] constexpr std::uint64_t hashCoordinates(std::span<const std::int32_t> coordinates) noexcept
{
    std::uint64_t hash = coordinates.size();
    std::size_t i = 0;
    for (; i + 1 < coordinates.size(); i += 2)
        hash = mix(hash, (static_cast<std::uint64_t>(static_cast<std::uint32_t>(coordinates[i])) << 32) |
                             static_cast<std::uint32_t>(coordinates[i + 1]));
    if (i < coordinates.size())
        hash = mix(hash, static_cast<std::uint32_t>(coordinates[i]));
    return hash;
}
}  // namespace specplan::util
