// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "specplan/lattice/GridHeuristic.h"
#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/lattice/Lattice.h"
#include "specplan/search/AStar.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::test
{
/// A search over a map of text: '#' is blocked, 'S' the start, 'G' the goal. On a virtual clock, a second a check.
class TextGrid : public validity::Checker
{
public:
    TextGrid(std::vector<std::string> rows, unsigned workers, bool motionChecks = false)
        : rows_(std::move(rows)),
          lattice(std::make_unique<lattice::GridNeighbourhood>(
              lattice::GridBox{{0, 0}, {static_cast<int>(rows_[0].size()) - 1, static_cast<int>(rows_.size()) - 1}},
              steps(motionChecks))),
          heuristic(lattice, {1.0, 1.0}, 2),
          executor(*this, workers, [](lattice::CheckId, bool) { return 1.0; }),
          broker(executor),
          search(lattice, heuristic, broker, 1.0)
    {
        const auto [startX, startY] = find('S');
        const auto [goalX, goalY] = find('G');
        heuristic.addGoal({{static_cast<double>(goalX), static_cast<double>(goalY)}, {}});
        search.addGoal(node(goalX, goalY));
        broker.setVerdict(lattice::CheckId::ofState(node(startX, startY)), true);
        search.addStart(node(startX, startY));
    }

    lattice::NodeId node(int x, int y)
    {
        const lattice::Coordinate place[] = {x, y};
        return lattice.node(place);
    }

    bool check(lattice::CheckId check, unsigned) override
    {
        checked.push_back(check);
        return check.isMotion() || isFree(check.node());
    }

    [[nodiscard]] bool isFree(lattice::NodeId id) const
    {
        const auto at = lattice.coordinates(id);
        return rows_[static_cast<std::size_t>(at[1])][static_cast<std::size_t>(at[0])] != '#';
    }

    void use(speculation::Policy& policy)
    {
        broker.setSource(&policy);
        search.setPolicy(&policy);
    }

    search::SearchStatus run()
    {
        const search::SearchStatus status = search.run([] { return false; });
        broker.settle();
        return status;
    }

private:
    static lattice::GridSteps steps(bool motionChecks)
    {
        lattice::GridSteps steps;
        steps.cost = [](std::span<const lattice::Coordinate> offset) { return std::hypot(offset[0], offset[1]); };
        steps.motionCheck = [motionChecks](std::span<const lattice::Coordinate>) { return motionChecks; };
        return steps;
    }

    [[nodiscard]] std::pair<int, int> find(char mark) const
    {
        for (std::size_t y = 0; y < rows_.size(); ++y)
            if (const auto x = rows_[y].find(mark); x != std::string::npos)
                return {static_cast<int>(x), static_cast<int>(y)};
        throw std::invalid_argument("the map has no such mark");
    }

    std::vector<std::string> rows_;

public:
    lattice::Lattice lattice;
    lattice::GridHeuristic heuristic;
    validity::VirtualExecutor executor;
    validity::Broker broker;
    search::AStar search;
    std::vector<lattice::CheckId> checked;  ///< in order
};
}  // namespace specplan::test
