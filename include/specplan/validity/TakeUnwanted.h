// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <vector>

#include "specplan/lattice/CheckId.h"

namespace specplan::validity
{
/// Moves the checks that nobody wants from a queue to `dropped`.
inline void takeUnwanted(std::deque<lattice::CheckId>& queue, const std::function<bool(lattice::CheckId)>& isWanted,
                         std::vector<lattice::CheckId>& dropped)
{
    const auto firstUnwanted = std::stable_partition(queue.begin(), queue.end(), isWanted);
    dropped.insert(dropped.end(), firstUnwanted, queue.end());
    queue.erase(firstUnwanted, queue.end());
}
}  // namespace specplan::validity
