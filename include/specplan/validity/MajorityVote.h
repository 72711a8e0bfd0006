// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>

namespace specplan::validity
{
/// What most of the last observations said: an outlier changes nothing, a lasting change does after half of the window.
class MajorityVote
{
public:
    void add(bool yes) noexcept
    {
        votes_ = (votes_ << 1U | (yes ? 1U : 0U)) & ((1U << kWindow) - 1U);
        count_ += count_ < kWindow ? 1U : 0U;
    }

    [[nodiscard]] bool isEmpty() const noexcept
    {
        return count_ == 0;
    }

    /// False as long as nothing is known.
    [[nodiscard]] bool yes() const noexcept
    {
        return 2U * static_cast<unsigned>(std::popcount(votes_)) > count_;
    }

private:
    static constexpr unsigned kWindow = 7;

    std::uint32_t votes_ = 0;  ///< one bit for each of the last observations, newest lowest
    unsigned count_ = 0;
};
}  // namespace specplan::validity
