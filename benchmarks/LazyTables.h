// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "specplan/problems/GridMap.h"

namespace specplan::benchmarks
{
struct LazyCase
{
    std::string name;
    problems::GridProblem problem;
    bool cornerCutting;
};

/// Prints the tables of the lazy search, on the virtual clock with unit checks and octile costs, as Markdown, and
/// writes a line of CSV for each search: speed-up over sequential A* by number of workers, checks by selector and
/// weight beside those of a lazy A*, and what the search itself costs. \throws std::runtime_error if a cost is not
/// within the weight of A*'s.
void printLazyTables(const std::vector<LazyCase>& suite, const std::string& name, std::ostream& csv);
}  // namespace specplan::benchmarks
