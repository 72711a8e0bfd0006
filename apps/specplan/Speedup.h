// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "Options.h"

namespace specplan::command
{
/// `specplan speedup`: the paper's experiment. Sequential A* first, then every policy with every number of threads;
/// each has to expand the same states in the same order. \return the exit status. \throws InputError before anything is
/// planned or written, if the input is bad. \throws std::logic_error if an order of expansions differs.
[[nodiscard]] int speedup(const SpeedupOptions& options, std::ostream& out);
}  // namespace specplan::command
