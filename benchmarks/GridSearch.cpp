// SPDX-License-Identifier: BSD-3-Clause
#include "GridSearch.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "specplan/lattice/GridHeuristic.h"
#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/search/AStar.h"
#include "specplan/speculation/DirectionPolicy.h"
#include "specplan/speculation/LearningPredictor.h"
#include "specplan/speculation/NearbyPredictor.h"
#include "specplan/speculation/RunAheadPolicy.h"
#include "specplan/util/Hash.h"
#include "specplan/validity/RunCheck.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::benchmarks
{
namespace
{
using lattice::CheckId;
using lattice::NodeId;
using problems::GridCost;
using problems::GridMap;

class MapChecker : public validity::Checker
{
public:
    MapChecker(const GridMap& map, const lattice::Lattice& lattice) : map_(map), lattice_(lattice)
    {
    }

    bool check(CheckId check, unsigned) override
    {
        const auto at = lattice_.coordinates(check.node());
        return map_.isFree(at[0], at[1]);
    }

private:
    const GridMap& map_;
    const lattice::Lattice& lattice_;
};

/// Heuristics of the costs that count moves.
class MoveHeuristic : public lattice::Heuristic
{
public:
    MoveHeuristic(const lattice::Lattice& lattice, const problems::GridCell& goal, bool straight)
        : lattice_(lattice), goal_(goal), straight_(straight)
    {
    }

    [[nodiscard]] double estimate(NodeId node) const override
    {
        const auto at = lattice_.coordinates(node);
        const double dx = std::abs(at[0] - goal_[0]);
        const double dy = std::abs(at[1] - goal_[1]);
        return straight_ ? std::hypot(dx, dy) : std::max(dx, dy);
    }

private:
    const lattice::Lattice& lattice_;
    problems::GridCell goal_;
    bool straight_;
};

/// Duration of the check of a cell: drawn at random, but always the same for the same cell.
double durationOf(Durations durations, std::span<const lattice::Coordinate> cell, bool valid)
{
    const auto draw = [cell](std::uint64_t salt)
    { return (static_cast<double>(util::mix(salt, util::hashCoordinates(cell)) >> 11U) + 0.5) * 0x1p-53; };
    switch (durations)
    {
        case Durations::Constant:
            break;
        case Durations::Uniform:
            return 0.5 + draw(1);
        case Durations::LogNormal:
            return std::exp(std::sqrt(-2.0 * std::log(draw(1))) * std::cos(2.0 * std::numbers::pi * draw(2)));
        case Durations::CheapInvalid:
            return valid ? 1.0 : 0.1;
    }
    return 1.0;
}

lattice::GridSteps stepsOf(const GridSearch& search)
{
    lattice::GridSteps steps;
    steps.cornerCutting = search.cornerCutting;
    steps.cost = [octile = search.cost == GridCost::Length](std::span<const lattice::Coordinate> offset)
    { return octile ? std::hypot(offset[0], offset[1]) : 1.0; };
    return steps;
}

std::unique_ptr<speculation::Predictor> makePredictor(const std::string& name, lattice::Lattice& lattice)
{
    if (name == "optimistic")
        return std::make_unique<speculation::OptimisticPredictor>();
    if (name == "nearby")
        return std::make_unique<speculation::NearbyPredictor>(lattice);
    return std::make_unique<speculation::LearningPredictor>(lattice);
}

std::unique_ptr<speculation::Policy> makePolicy(const std::string& name, lattice::Lattice& lattice,
                                                validity::Broker& broker, const search::AStar& search,
                                                speculation::Predictor& predictor, double weight)
{
    if (name == "runahead")
        return std::make_unique<speculation::RunAheadPolicy>(lattice, broker, search, predictor, weight);
    if (name == "direction")
        return std::make_unique<speculation::DirectionPolicy>(lattice, broker, 4);
    return nullptr;
}
}  // namespace

Outcome searchVirtually(const GridSearch& wanted)
{
    const GridMap& map = wanted.problem->map;
    lattice::Lattice lattice(std::make_unique<lattice::GridNeighbourhood>(
        lattice::GridBox{{0, 0}, {map.width() - 1, map.height() - 1}}, stepsOf(wanted)));
    const auto node = [&lattice](const problems::GridCell& cell) {
        return lattice.node(std::array<lattice::Coordinate, 2>{cell[0], cell[1]}.data());
    };
    const problems::GridCell& goal = wanted.problem->goal;
    lattice::GridHeuristic octile(lattice, {1.0, 1.0}, 2);
    octile.addGoal({{static_cast<double>(goal[0]), static_cast<double>(goal[1])}, {}});
    const MoveHeuristic moves(lattice, goal, wanted.cost == GridCost::Seed);
    MapChecker checker(map, lattice);
    validity::VirtualExecutor executor(
        checker, wanted.workers,
        [&](CheckId check, bool valid)
        { return durationOf(wanted.durations, lattice.coordinates(check.node()), valid); });
    validity::Broker broker(executor);
    broker.setBarrier(wanted.policy == "direction");
    search::AStar search(lattice,
                         wanted.cost == GridCost::Length ? static_cast<const lattice::Heuristic&>(octile) : moves,
                         broker, wanted.weight);
    const auto predictor = makePredictor(wanted.predictor, lattice);
    const auto policy = makePolicy(wanted.policy, lattice, broker, search, *predictor, wanted.weight);
    broker.setSource(policy.get());
    search.setPolicy(policy.get());
    search.addGoal(node(goal));
    search.addStart(node(wanted.problem->start));

    const double start = validity::steadySeconds();
    search.run([] { return false; });
    const double seconds = broker.now();
    const double searchSeconds = validity::steadySeconds() - start;
    broker.settle();
    return {broker.statistics(), search.expansions(),
            search.orderHash(),  seconds,
            searchSeconds,       broker.statistics().usedSeconds / seconds};
}
}  // namespace specplan::benchmarks
