// SPDX-License-Identifier: BSD-3-Clause
#include "GridSearch.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "specplan/lattice/GridHeuristic.h"
#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/search/AStar.h"
#include "specplan/speculation/DirectionPolicy.h"
#include "specplan/speculation/HedgedPolicy.h"
#include "specplan/speculation/LearningPredictor.h"
#include "specplan/speculation/NearbyPredictor.h"
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
                                                speculation::Predictor& predictor, double weight, unsigned workers)
{
    if (name == "runahead")
        return speculation::makeRunAhead(lattice, broker, search, predictor, weight, workers);
    if (name == "direction")
        return std::make_unique<speculation::DirectionPolicy>(lattice, broker, 4);
    return nullptr;
}
/// One problem with a lattice of its own.
struct Arena
{
    explicit Arena(const GridSearch& wanted)
        : lattice(std::make_unique<lattice::GridNeighbourhood>(
              lattice::GridBox{{0, 0}, {wanted.problem->map.width() - 1, wanted.problem->map.height() - 1}},
              stepsOf(wanted))),
          octile(lattice, {1.0, 1.0}, 2),
          moves(lattice, wanted.problem->goal, wanted.cost == GridCost::Seed),
          heuristic(wanted.cost == GridCost::Length ? static_cast<const lattice::Heuristic&>(octile) : moves),
          checker(wanted.problem->map, lattice),
          executor(checker, wanted.workers,
                   [this, durations = wanted.durations](CheckId check, bool valid)
                   { return durationOf(durations, lattice.coordinates(check.node()), valid); }),
          broker(executor),
          start(node(wanted.problem->start)),
          goal(node(wanted.problem->goal))
    {
        const problems::GridCell& cell = wanted.problem->goal;
        octile.addGoal({{static_cast<double>(cell[0]), static_cast<double>(cell[1])}, {}});
    }

    NodeId node(const problems::GridCell& cell)
    {
        return lattice.node(std::array<lattice::Coordinate, 2>{cell[0], cell[1]}.data());
    }

    /// Runs a search of either kind and measures it.
    template <typename Search>
    Outcome run(Search& search)
    {
        search.addGoal(goal);
        search.addStart(start);
        const double begin = validity::steadySeconds();
        search.run([] { return false; });
        const double searchSeconds = validity::steadySeconds() - begin;
        const double seconds = broker.now();
        broker.settle();
        return {broker.statistics(),
                search.expansions(),
                search.orderHash(),
                seconds,
                searchSeconds,
                broker.statistics().usedSeconds / seconds,
                search.costToCome(search.reachedGoal())};
    }

    lattice::Lattice lattice;
    lattice::GridHeuristic octile;
    MoveHeuristic moves;
    const lattice::Heuristic& heuristic;
    MapChecker checker;
    validity::VirtualExecutor executor;
    validity::Broker broker;
    NodeId start;
    NodeId goal;
};
}  // namespace

Outcome searchVirtually(const GridSearch& wanted)
{
    Arena arena(wanted);
    arena.broker.setBarrier(wanted.policy == "direction");
    search::AStar search(arena.lattice, arena.heuristic, arena.broker, wanted.weight);
    const auto predictor = makePredictor(wanted.predictor, arena.lattice);
    const auto policy =
        makePolicy(wanted.policy, arena.lattice, arena.broker, search, *predictor, wanted.weight, wanted.workers);
    arena.broker.setSource(policy.get());
    search.setPolicy(policy.get());
    return arena.run(search);
}

Outcome searchLazily(const GridSearch& wanted, search::Selector selector)
{
    Arena arena(wanted);
    search::LazySearch search(arena.lattice, arena.heuristic, arena.broker, wanted.weight);
    search.setSelector(selector);
    if (wanted.workers > 1)
        arena.broker.setSource(&search);
    return arena.run(search);
}

BaselineResult searchBaseline(const GridSearch& wanted)
{
    Arena arena(wanted);
    return lazyAStar(arena.lattice, arena.heuristic, arena.checker, arena.start, arena.goal, wanted.weight);
}
}  // namespace specplan::benchmarks
