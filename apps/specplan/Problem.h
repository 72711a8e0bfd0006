// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/PlannerSettings.h"
#include "specplan/problems/ArtificialCheck.h"
#include "specplan/problems/OmplAppProblem.h"

namespace specplan::command
{
struct ProblemOptions;
struct Run;

/// How a problem's file wants to be benchmarked; what it does not say is empty.
struct BenchmarkWishes
{
    std::string experiment;
    std::vector<problems::PlannerRequest> planners;
    std::optional<double> timeLimit;    ///< seconds a run
    std::optional<double> memoryLimit;  ///< MB a run
    std::optional<unsigned> runCount;
};

/// A problem of the command line, ready to be set up any number of times.
class Problem
{
public:
    explicit Problem(std::string name) : name_(std::move(name))
    {
    }

    virtual ~Problem() = default;
    Problem(const Problem&) = delete;
    Problem& operator=(const Problem&) = delete;

    /// What to call it in tables: the file, and the scenario's entry if one was used.
    [[nodiscard]] const std::string& name() const noexcept
    {
        return name_;
    }

    /// The files that it was read from.
    [[nodiscard]] virtual std::vector<std::string> inputs() const = 0;

    /// A fresh set-up without a planner. \param check what each check takes besides its own work.
    /// \throws InputError if start or goal is of no use.
    [[nodiscard]] virtual std::shared_ptr<ompl::geometric::SimpleSetup> makeSetup(
        problems::ArtificialCheck check) const = 0;

    /// The user's settings with what this kind of problem settles.
    [[nodiscard]] virtual PlannerSettings settle(PlannerSettings chosen) const = 0;

    /// Draws a search as SVG.
    virtual void draw(std::ostream& out, const Run& run) const = 0;

    /// \throws InputError where there is no 3-D view of such a problem, or specplan was built without what it needs.
    virtual void requireView() const;

    /// Writes a page with a 3-D view of a search. \throws InputError as requireView() does.
    virtual void writeView(std::ostream& out, const Run& run) const;

    /// Adds to a trace: the problem, the expanded states in order, and the path.
    virtual void describe(nlohmann::ordered_json& trace, const Run& run) const = 0;

    /// What the problem's file says about benchmarks.
    [[nodiscard]] virtual BenchmarkWishes benchmarkWishes() const
    {
        return {};
    }

private:
    std::string name_;
};

/// Reads a Moving AI map, a map in the seed's format or a problem of OMPL.app, by the looks of the file; "-" is
/// standard input. What such a file says and nobody heeds is reported on standard error, a line each. \throws
/// InputError naming file, line or option.
[[nodiscard]] std::unique_ptr<Problem> readProblem(const std::string& file, const ProblemOptions& options);
}  // namespace specplan::command
