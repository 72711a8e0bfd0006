// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "Run.h"

namespace specplan::command
{
/// All checks of a run with a trace as comma-separated values with a heading, in the order in which they began: kind
/// (state or motion), valid and used (1 or 0), start_s and duration_s (seconds), worker, from and to (values separated
/// by blanks; `to` is empty for states).
void writeChecks(std::ostream& out, const Run& run);
}  // namespace specplan::command
