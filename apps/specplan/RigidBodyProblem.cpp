// SPDX-License-Identifier: BSD-3-Clause
#include "RigidBodyProblem.h"

#include <iostream>

#include <ompl/base/goals/GoalState.h>

#include "MeshReader.h"
#include "RigidBodyPicture.h"
#include "RigidBodyView.h"
#include "Run.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/fcl/RigidBodySetup.h"

namespace specplan::command
{
namespace ob = ompl::base;
using problems::concat;
using problems::InputError;
using problems::RigidBodySetup;

namespace
{
/// A rigid body among obstacles.
class RigidBodyProblem : public Problem
{
public:
    /// \param file that the problem was read from.
    RigidBodyProblem(std::string file, RigidBodySetup setup)
        : Problem(setup.problem().file), file_(std::move(file)), setup_(std::move(setup))
    {
    }

    [[nodiscard]] std::vector<std::string> inputs() const override
    {
        return {file_, setup_.problem().robot.path, setup_.problem().world.path};
    }

    [[nodiscard]] std::shared_ptr<ompl::geometric::SimpleSetup> makeSetup(
        problems::ArtificialCheck check) const override
    {
        return setup_.makeSetup(check);
    }

    [[nodiscard]] PlannerSettings settle(PlannerSettings chosen) const override
    {
        return chosen;
    }

    void draw(std::ostream& out, const Run& run) const override
    {
        drawSearch(out, setup_, run);
    }

    void requireView() const override
    {
        requireViewer();
    }

    void writeView(std::ostream& out, const Run& run) const override
    {
        viewSearch(out, setup_, run);
    }

    void describe(nlohmann::ordered_json& trace, const Run& run) const override
    {
        const ob::ProblemDefinition& definition = *run.setup->getProblemDefinition();
        const auto numbers = [&run](const ob::State* state)
        {
            std::vector<double> reals;
            run.setup->getStateSpace()->copyToReals(reals, state);
            return reals;
        };
        const ob::RealVectorBounds& bounds = setup_.bounds();
        trace["planar"] = setup_.problem().planar;
        trace["bounds"] = {{"low", bounds.low}, {"high", bounds.high}};
        trace["start"] = numbers(definition.getStartState(0));
        trace["goal"] = numbers(definition.getGoal()->as<ob::GoalState>()->getState());
        trace["expanded"] = run.expanded;
        trace["path"] = run.path;
    }

    [[nodiscard]] BenchmarkWishes benchmarkWishes() const override
    {
        const problems::OmplAppProblem& problem = setup_.problem();
        return {problem.name, problem.planners, problem.timeLimit, problem.memoryLimit, problem.runCount};
    }

private:
    std::string file_;
    RigidBodySetup setup_;
};

/// Options that only maps have.
void refuseMapOptions(const std::string& file, const ProblemOptions& options)
{
    const char* option = options.start                                ? "--start"
                         : options.goal                               ? "--goal"
                         : !options.scenario.empty()                  ? "--scen"
                         : options.cornerCutting                      ? "--corner-cutting"
                         : options.cost != problems::GridCost::Length ? "--cost"
                                                                      : nullptr;
    if (option != nullptr)
        throw InputError(concat(option, ": expected a map with this; ", file, " says itself what is wanted"));
}
}  // namespace

std::unique_ptr<Problem> readRigidBodyProblem(Input input, const ProblemOptions& options)
{
    refuseMapOptions(input.name, options);
    problems::OmplAppProblem problem = problems::parseOmplAppProblem(std::move(input.text), input.name);
    if (options.validityResolution)
        problem.longestValidSegmentFraction = options.validityResolution;
    RigidBodySetup setup(std::move(problem), &readMeshApart);
    for (const std::string& warning : setup.warnings())
        std::cerr << "specplan: warning: " << warning << '\n';
    return std::make_unique<RigidBodyProblem>(std::move(input.file), std::move(setup));
}
}  // namespace specplan::command
