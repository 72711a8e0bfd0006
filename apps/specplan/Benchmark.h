// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "Options.h"

namespace specplan::command
{
/// `specplan benchmark`: OMPL's Benchmark over several planners. An interrupt ends it; the runs completed are kept, in
/// the log too. \return 0 if each planner has solved the problem, otherwise 1.
/// \throws InputError before anything is planned or written, if the input is bad.
[[nodiscard]] int benchmark(const BenchmarkOptions& options, std::ostream& out);
}  // namespace specplan::command
