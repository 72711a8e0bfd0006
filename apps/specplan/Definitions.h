// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "Options.h"

namespace specplan::command
{
/// Gives a subcommand its arguments and options. The options are filled when the command line is parsed, and have to be
/// there until then. Bad values are refused with one line that names the option.
void definePlan(CLI::App& app, PlanOptions& options);
void defineBenchmark(CLI::App& app, BenchmarkOptions& options);
void defineSpeedup(CLI::App& app, SpeedupOptions& options);
}  // namespace specplan::command
