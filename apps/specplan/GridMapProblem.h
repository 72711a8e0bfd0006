// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "Options.h"
#include "Problem.h"
#include "specplan/problems/GridMap.h"

namespace specplan::command
{
/// A way through a grid map.
class GridMapProblem : public Problem
{
public:
    /// \param cornerCutting whether diagonal moves may pass a blocked corner.
    GridMapProblem(std::string name, std::string file, problems::GridProblem problem, problems::GridCost cost,
                   bool cornerCutting);

    [[nodiscard]] std::shared_ptr<ompl::geometric::SimpleSetup> makeSetup(
        problems::ArtificialCheck check) const override;
    [[nodiscard]] PlannerSettings settle(PlannerSettings chosen) const override;
    void draw(std::ostream& out, const Run& run) const override;
    void describe(nlohmann::ordered_json& trace, const Run& run) const override;

private:
    std::string file_;
    problems::GridProblem problem_;
    problems::GridCost cost_;
    bool cornerCutting_;
};

/// Reads a Moving AI map or a map in the seed's format. \throws InputError naming file, line or option.
[[nodiscard]] std::unique_ptr<Problem> readGridMapProblem(const std::string& file, const ProblemOptions& options);

/// The cells of states.
[[nodiscard]] std::vector<problems::GridCell> cellsOf(const std::vector<std::vector<double>>& states);
}  // namespace specplan::command
