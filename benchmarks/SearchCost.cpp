// SPDX-License-Identifier: BSD-3-Clause
// What the search itself costs when checks cost nothing: expansions a second, sequential, on a map of 257 × 256 cells,
// through the core alone and through OMPL states.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>

#include "specplan/lattice/GridHeuristic.h"
#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/search/AStar.h"
#include "specplan/util/Hash.h"
#include "specplan/validity/InlineExecutor.h"

namespace specplan::benchmarks
{
namespace
{
namespace ob = ompl::base;
using lattice::CheckId;
using lattice::Coordinate;

/// Blocks of 8 × 8 cells, one in four of them solid; start and goal in opposite corners.
class Map
{
public:
    static constexpr int kWidth = 257;
    static constexpr int kHeight = 256;

    Map() : free_(std::size_t{kWidth} * kHeight)
    {
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                free_[index(x, y)] = isOpen(x / 8, y / 8);
    }

    [[nodiscard]] bool isFree(int x, int y) const
    {
        return free_[index(x, y)];
    }

private:
    static std::size_t index(int x, int y)
    {
        return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
    }

    static bool isOpen(int column, int row)
    {
        const std::int32_t block[] = {column, row};
        const bool corner = column + row < 4 || column + row > 58;
        return corner || util::hashCoordinates(block) % 4 != 0;
    }

    std::vector<bool> free_;
};

class MapChecker : public validity::Checker
{
public:
    MapChecker(const Map& map, const lattice::Lattice& lattice) : map_(map), lattice_(lattice)
    {
    }

    bool check(CheckId check, unsigned) override
    {
        const auto cell = lattice_.coordinates(check.node());
        return map_.isFree(cell[0], cell[1]);
    }

private:
    const Map& map_;
    const lattice::Lattice& lattice_;
};

void core(benchmark::State& state)
{
    const Map map;
    std::uint64_t expansions = 0;
    for (auto _ : state)
    {
        lattice::GridSteps steps;
        steps.cost = [](std::span<const Coordinate> offset) { return std::hypot(offset[0], offset[1]); };
        lattice::Lattice lattice(std::make_unique<lattice::GridNeighbourhood>(
            lattice::GridBox{{0, 0}, {Map::kWidth - 1, Map::kHeight - 1}}, steps));
        lattice::GridHeuristic heuristic(lattice, {1.0, 1.0}, 2);
        heuristic.addGoal({{Map::kWidth - 1.0, Map::kHeight - 1.0}, {}});
        MapChecker checker(map, lattice);
        validity::InlineExecutor executor(checker);
        validity::Broker broker(executor);
        search::AStar search(lattice, heuristic, broker, 1.0);
        const Coordinate start[] = {0, 0};
        const Coordinate goal[] = {Map::kWidth - 1, Map::kHeight - 1};
        search.addGoal(lattice.node(goal));
        search.addStart(lattice.node(start));
        if (search.run([] { return false; }) != search::SearchStatus::Solved)
            state.SkipWithError("not solved");
        expansions += search.expansions();
    }
    state.counters["expansions/s"] = benchmark::Counter(static_cast<double>(expansions), benchmark::Counter::kIsRate);
}

void planner(benchmark::State& state)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const Map map;
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    ob::RealVectorBounds bounds(2);
    bounds.low = {-0.5, -0.5};
    bounds.high = {Map::kWidth - 0.5, Map::kHeight - 0.5};
    space->setBounds(bounds);
    space->setLongestValidSegmentFraction(1.5 / space->getMaximumExtent());
    ompl::geometric::SimpleSetup setup(space);
    setup.setStateValidityChecker(
        [&map](const ob::State* at)
        {
            const double* xy = at->as<ob::RealVectorStateSpace::StateType>()->values;
            return map.isFree(static_cast<int>(std::lround(xy[0])), static_cast<int>(std::lround(xy[1])));
        });
    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    start[0] = start[1] = 0.0;
    goal[0] = Map::kWidth - 1.0;
    goal[1] = Map::kHeight - 1.0;
    setup.setStartAndGoalStates(start, goal);
    PlannerSettings settings;
    settings.numThreads = 1;
    settings.spacing = {1.0};
    auto made = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settings);
    setup.setPlanner(made);
    setup.setup();
    std::uint64_t expansions = 0;
    for (auto _ : state)
    {
        made->clear();
        setup.getProblemDefinition()->clearSolutionPaths();
        if (made->solve(60.0) != ob::PlannerStatus::EXACT_SOLUTION)
            state.SkipWithError("not solved");
        expansions += made->getReport().expansions;
    }
    state.counters["expansions/s"] = benchmark::Counter(static_cast<double>(expansions), benchmark::Counter::kIsRate);
}

BENCHMARK(core)->Unit(benchmark::kMillisecond);
BENCHMARK(planner)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace specplan::benchmarks

BENCHMARK_MAIN();
