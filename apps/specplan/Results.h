// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <vector>

#include <nlohmann/json.hpp>

#include "Run.h"

namespace specplan::command
{
/// All figures of a run, under the names that every output uses. Numbers that do not exist (the cost of no solution)
/// are null.
[[nodiscard]] nlohmann::ordered_json toJson(const Run& run);

/// The same for people, one figure a line.
void printRun(std::ostream& out, const Run& run);

/// Table of runs, one a line, with the columns of the paper's tables.
class Table
{
public:
    explicit Table(std::ostream& out) : out_(out)
    {
    }

    /// Prints a line; a heading before the first one of each problem.
    void add(const Run& run);

private:
    void printHeading(const Run& run);

    std::ostream& out_;
    std::string problem_;
};

/// Comma-separated values with a heading, one run a line.
void writeCsv(std::ostream& out, const std::vector<Run>& runs);
}  // namespace specplan::command
