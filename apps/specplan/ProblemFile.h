// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "Options.h"

namespace specplan::command
{
/// A problem and what to call it in tables.
struct NamedProblem
{
    std::string name;  ///< the file, and the scenario's entry if one was used
    std::string file;
    problems::GridProblem problem;
    bool cornerCutting;  ///< maps in the seed's format always allow it, as the seed's program does
};

/// Reads a Moving AI map or a map in the seed's format.
/// \throws InputError naming file, line or option.
[[nodiscard]] NamedProblem readProblem(const std::string& file, const ProblemOptions& options);
}  // namespace specplan::command
