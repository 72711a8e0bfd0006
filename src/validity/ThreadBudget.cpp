// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/ThreadBudget.h"

#include <algorithm>
#include <thread>

namespace specplan
{
ThreadBudget::ThreadBudget(unsigned threads)
    : threads_(threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1U))
{
}
}  // namespace specplan
