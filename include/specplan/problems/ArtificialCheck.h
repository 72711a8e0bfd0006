// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace specplan::problems
{
/// Time that each check takes besides its own work.
struct ArtificialCheck
{
    std::chrono::nanoseconds duration{0};
    bool busy = false;  ///< burn CPU instead of sleeping
};

/// Lets that time pass. Any number of threads at once.
void pass(const ArtificialCheck& check);
}  // namespace specplan::problems
