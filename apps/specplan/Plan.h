// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "Options.h"

namespace specplan::command
{
/// `specplan plan`: solves one problem and writes what was asked for. \return the exit status.
/// \throws InputError before anything is planned or written, if the input is bad.
[[nodiscard]] int plan(const PlanOptions& options, std::ostream& out);
}  // namespace specplan::command
