// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>

#include "specplan/lattice/GridHeuristic.h"
#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/search/LatticeSearch.h"
#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::test
{
/// Answers for a plane with a wall at x = 12 that is open at y < gap; checks of some cells throw or last.
class PlaneChecker : public validity::Checker
{
public:
    explicit PlaneChecker(const lattice::Lattice& lattice) : lattice_(lattice)
    {
    }

    bool check(lattice::CheckId check, unsigned) override
    {
        ++calls;
        if (check.isMotion())
            return motionsValid;
        const lattice::Coordinate x = lattice_.coordinates(check.node())[0];
        const lattice::Coordinate y = lattice_.coordinates(check.node())[1];
        if (sleep.count() > 0)
            std::this_thread::sleep_for(sleep);
        if (x == throwAt)
            throw std::runtime_error("no answer for x = " + std::to_string(x));
        return x != 12 || y < gap;
    }

    std::atomic<int> calls{0};
    lattice::Coordinate throwAt = -1;
    lattice::Coordinate gap = 30;  ///< no wall
    bool motionsValid = true;
    std::chrono::milliseconds sleep{0};

private:
    const lattice::Lattice& lattice_;
};

/// 30 × 30 cells, to be searched from (2, 15) to (goalX, 15) with the executor under test.
struct Plane
{
    explicit Plane(unsigned workers, bool simulated, lattice::Coordinate goalX)
        : lattice(std::make_unique<lattice::GridNeighbourhood>(lattice::GridBox{{0, 0}, {29, 29}}, steps())),
          checker(lattice),
          heuristic(lattice, {1.0, 1.0}, 2)
    {
        if (simulated)
            executor = std::make_unique<validity::VirtualExecutor>(checker, workers,
                                                                   [](lattice::CheckId, bool) { return 1.0; });
        else if (workers == 1)
            executor = std::make_unique<validity::InlineExecutor>(checker);
        else
            executor = std::make_unique<validity::ThreadPoolExecutor>(checker, workers);
        broker = std::make_unique<validity::Broker>(*executor);
        heuristic.addGoal({{static_cast<double>(goalX), 15.0}, {}});
    }

    static lattice::GridSteps steps()
    {
        lattice::GridSteps steps;
        steps.cost = [](std::span<const lattice::Coordinate> offset) { return std::hypot(offset[0], offset[1]); };
        return steps;
    }

    lattice::NodeId node(lattice::Coordinate x, lattice::Coordinate y)
    {
        const lattice::Coordinate cell[] = {x, y};
        return lattice.node(cell);
    }

    lattice::Lattice lattice;
    PlaneChecker checker;
    lattice::GridHeuristic heuristic;
    std::unique_ptr<validity::Executor> executor;
    std::unique_ptr<validity::Broker> broker;
};
}  // namespace specplan::test
