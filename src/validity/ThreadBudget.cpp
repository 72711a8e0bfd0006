// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/ThreadBudget.h"

#include "specplan/util/Processors.h"

namespace specplan
{
ThreadBudget::ThreadBudget(unsigned threads) : threads_(threads > 0 ? threads : util::availableProcessors())
{
}
}  // namespace specplan
