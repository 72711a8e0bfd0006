// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

#include <nlohmann/json.hpp>

#include "Options.h"
#include "Problem.h"
#include "Run.h"

namespace specplan::command
{
/// A run beside the sequential one.
struct Verification
{
    Run sequential;
    std::string difference;    ///< empty if there is none
    bool interrupted = false;  ///< by the user, before the sequential run came as far as the other
};

/// Searches again with one thread and no speculation, and compares. The time limit does not hold for this run: it ends
/// with its search, or where the other was stopped. \param run with its Run::order.
[[nodiscard]] Verification verify(const Problem& problem, const CommonOptions& options, const Run& run);

[[nodiscard]] nlohmann::ordered_json toJson(const Verification& verification, const Run& run);

/// The same for people, in one line.
void printVerification(std::ostream& out, const Verification& verification, const Run& run);
}  // namespace specplan::command
