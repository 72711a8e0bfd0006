// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "Options.h"

namespace specplan::command
{
/// `specplan benchmark`: OMPL's Benchmark over several planners. An interrupt ends it; the runs completed are kept, in
/// the log too. \return the exit status: solved means that each planner has solved the problem.
/// \throws InputError before anything is planned or written, if the input is bad.
[[nodiscard]] int benchmark(const BenchmarkOptions& options, std::ostream& out);
}  // namespace specplan::command
