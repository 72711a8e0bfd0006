// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "Input.h"
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
    /// \param inputs the files that it comes from, the map first.
    GridMapProblem(std::string name, std::vector<Input> inputs, problems::GridProblem problem, problems::GridCost cost,
                   bool cornerCutting);

    [[nodiscard]] std::shared_ptr<ompl::geometric::SimpleSetup> makeSetup(
        problems::ArtificialCheck check) const override;
    [[nodiscard]] std::vector<std::string> inputs() const override;
    [[nodiscard]] PlannerSettings settle(PlannerSettings chosen) const override;
    void draw(std::ostream& out, const Run& run) const override;
    void describe(nlohmann::ordered_json& trace, const Run& run) const override;

private:
    std::vector<Input> inputs_;  ///< without their texts
    problems::GridProblem problem_;
    problems::GridCost cost_;
    bool cornerCutting_;
};

/// Reads a Moving AI map or a map in the seed's format. \throws InputError naming file, line or option.
[[nodiscard]] std::unique_ptr<Problem> readGridMapProblem(Input input, const ProblemOptions& options);

/// The cells of states.
[[nodiscard]] std::vector<problems::GridCell> cellsOf(const std::vector<std::vector<double>>& states);
}  // namespace specplan::command
