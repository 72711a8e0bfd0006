// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "specplan/planner/PlannerSettings.h"
#include "specplan/problems/GridSetup.h"

namespace specplan::command
{
/// Where a problem comes from.
struct ProblemOptions
{
    std::vector<std::string> files;
    std::optional<problems::GridCell> start;
    std::optional<problems::GridCell> goal;
    std::string scenario;        ///< empty: the file beside the map, if there is one
    std::string index = "last";  ///< entry of the scenario, from 0, or "last"
    problems::GridCost cost = problems::GridCost::Length;
    bool cornerCutting = false;
    std::optional<double> validityResolution;  ///< of the file if empty; a share of the space's extent
};

/// Options that both subcommands have.
struct CommonOptions
{
    ProblemOptions problem;
    PlannerSettings planner;
    problems::ArtificialCheck check;
    std::optional<std::chrono::nanoseconds> timeLimit;
    bool anytime = false;  ///< go on after the first path
    bool json = false;
};

struct PlanOptions : CommonOptions
{
    bool explain = false;  ///< tell the lattice instead of searching it
    bool verify = false;   ///< run the sequential search beside
    std::string planWith;  ///< another planner instead of ours; empty: none
    std::string svgFile;
    std::string htmlFile;
    std::string traceFile;
    std::string pathFile;
    std::vector<unsigned> predict;  ///< numbers of workers to predict the time for; empty: none
    std::string csvFile;            ///< of the predictions
    std::string plotFile;           ///< of the predictions
};

struct BenchmarkOptions
{
    std::string file;
    std::optional<double> validityResolution;  ///< of the file if empty
    std::string planners;                      ///< empty: those of the file
    std::optional<unsigned> runs;
    std::optional<std::chrono::nanoseconds> timeLimit;
    std::optional<double> memoryLimit;  ///< MB
    problems::ArtificialCheck check;
    bool simplify = false;
    std::string logFile;
    bool json = false;
};

struct SpeedupOptions : CommonOptions
{
    std::vector<unsigned> threads{1, 2, 4, 8, 16, 32};
    std::vector<std::string> policies{"none", "direction", "runahead"};
    std::string csvFile;
    std::string plotFile;
};
}  // namespace specplan::command
