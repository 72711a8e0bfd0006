// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "Run.h"

namespace specplan::command
{
/// \throws InputError if gnuplot, which draws the plot, is not installed.
void requireGnuplot();

/// Plots speed-up against threads as SVG, one line a policy; of several problems the geometric mean.
/// \throws InputError if the file cannot be written.
void plotSpeedup(const std::string& file, const std::vector<Run>& runs);
}  // namespace specplan::command
