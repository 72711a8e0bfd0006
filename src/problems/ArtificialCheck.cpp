// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/ArtificialCheck.h"

#include <thread>

namespace specplan::problems
{
void pass(const ArtificialCheck& check)
{
    if (check.duration.count() <= 0)
        return;
    if (!check.busy)
    {
        std::this_thread::sleep_for(check.duration);
        return;
    }
    const auto end = std::chrono::steady_clock::now() + check.duration;
    while (std::chrono::steady_clock::now() < end)
    {
    }
}
}  // namespace specplan::problems
