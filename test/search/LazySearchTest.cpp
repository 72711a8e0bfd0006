// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/AStar.h"
#include "specplan/search/LazySearch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <thread>

#include "RandomProblem.h"
#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::test
{
namespace
{
using lattice::CheckId;
using lattice::Coordinate;
using lattice::NodeId;
using search::SearchStatus;

/// Plane of 30 × 30 cells with a wall at x = 12 that is open at y < 3; checks of some cells throw or last.
class WallChecker : public validity::Checker
{
public:
    explicit WallChecker(const lattice::Lattice& lattice) : lattice_(lattice)
    {
    }

    bool check(CheckId check, unsigned) override
    {
        ++calls;
        if (check.isMotion())
            return motionsValid;
        const Coordinate x = lattice_.coordinates(check.node())[0];
        const Coordinate y = lattice_.coordinates(check.node())[1];
        if (sleep.count() > 0)
            std::this_thread::sleep_for(sleep);
        if (x == throwAt)
            throw std::runtime_error("no answer for x = " + std::to_string(x));
        return x != 12 || y < gap;
    }

    std::atomic<int> calls{0};
    Coordinate throwAt = -1;
    Coordinate gap = 3;
    bool motionsValid = true;
    std::chrono::milliseconds sleep{0};

private:
    const lattice::Lattice& lattice_;
};

lattice::GridSteps planeSteps()
{
    lattice::GridSteps steps;
    steps.cost = [](std::span<const Coordinate> offset) { return std::hypot(offset[0], offset[1]); };
    return steps;
}

/// A search from (2, 15) to (goal, 15) with the executor under test.
struct Plane
{
    explicit Plane(unsigned workers, bool simulated, Coordinate goalX = 20)
        : lattice(std::make_unique<lattice::GridNeighbourhood>(lattice::GridBox{{0, 0}, {29, 29}}, planeSteps())),
          checker(lattice),
          heuristic(lattice, {1.0, 1.0}, 2)
    {
        if (simulated)
            executor = std::make_unique<validity::VirtualExecutor>(checker, workers, [](CheckId, bool) { return 1.0; });
        else if (workers == 1)
            executor = std::make_unique<validity::InlineExecutor>(checker);
        else
            executor = std::make_unique<validity::ThreadPoolExecutor>(checker, workers);
        broker = std::make_unique<validity::Broker>(*executor);
        search = std::make_unique<search::LazySearch>(lattice, heuristic, *broker);
        broker->setSource(search.get());
        heuristic.addGoal({{static_cast<double>(goalX), 15.0}, {}});
        search->addGoal(node(goalX, 15));
        search->addStart(node(2, 15));
    }

    NodeId node(Coordinate x, Coordinate y)
    {
        const Coordinate cell[] = {x, y};
        return lattice.node(cell);
    }

    SearchStatus run()
    {
        return search->run([] { return false; });
    }

    [[nodiscard]] double cost() const
    {
        return search->costToCome(search->reachedGoal());
    }

    lattice::Lattice lattice;
    WallChecker checker;
    lattice::GridHeuristic heuristic;
    std::unique_ptr<validity::Executor> executor;
    std::unique_ptr<validity::Broker> broker;
    std::unique_ptr<search::LazySearch> search;
};

/// From (2, 15) up to the gap at y = 2 and down again, along diagonals where possible.
double costThroughGap()
{
    return (10.0 * std::sqrt(2.0) + 3.0) + (8.0 * std::sqrt(2.0) + 5.0);
}

TEST(LazySearch, StopIsAskedBetweenDecisionsAndTheSearchGoesOn)
{
    Plane whole(1, false);
    ASSERT_EQ(whole.run(), SearchStatus::Solved);
    EXPECT_NEAR(whole.cost(), costThroughGap(), 1e-9);

    Plane stopped(1, false);
    int rounds = 0;
    SearchStatus status = SearchStatus::Stopped;
    while (status == SearchStatus::Stopped)
    {
        const std::uint64_t before = stopped.search->decisions();
        int allowed = 5;
        status = stopped.search->run([&] { return allowed-- == 0; });
        EXPECT_LE(stopped.search->decisions() - before, 5U);
        ASSERT_LT(++rounds, 1000);
    }
    EXPECT_EQ(status, SearchStatus::Solved);
    EXPECT_GT(rounds, 5);
    EXPECT_EQ(stopped.search->orderHash(), whole.search->orderHash());
    EXPECT_EQ(stopped.checker.calls, whole.checker.calls);
}

TEST(LazySearch, NeedsFewerChecksThanAStarForTheSameCost)
{
    Plane lazy(1, false);
    ASSERT_EQ(lazy.run(), SearchStatus::Solved);
    Plane eager(1, false);
    search::AStar aStar(eager.lattice, eager.heuristic, *eager.broker, 1.0);
    eager.broker->setSource(nullptr);
    aStar.addGoal(eager.node(20, 15));
    aStar.addStart(eager.node(2, 15));
    ASSERT_EQ(aStar.run([] { return false; }), SearchStatus::Solved);
    EXPECT_NEAR(lazy.cost(), aStar.costToCome(aStar.reachedGoal()), 1e-9);
    EXPECT_LT(lazy.checker.calls * 3, eager.checker.calls);
}

TEST(LazySearch, WorkersShortenTheVirtualTimeAndChangeNothing)
{
    Plane serial(1, false);
    ASSERT_EQ(serial.run(), SearchStatus::Solved);
    for (const auto& [workers, speedup] : {std::pair{2U, 1.3}, {4U, 2.0}, {16U, 5.0}})
    {
        Plane parallel(workers, true);
        ASSERT_EQ(parallel.run(), SearchStatus::Solved);
        parallel.broker->settle();
        EXPECT_EQ(parallel.search->orderHash(), serial.search->orderHash());
        EXPECT_EQ(parallel.search->decisions(), serial.search->decisions());
        EXPECT_LT(parallel.broker->now() * speedup, static_cast<double>(serial.search->decisions()));
    }
}

TEST(LazySearch, AnExceptionThatIsNeededSurfacesAfterTheSameDecisionsEverywhere)
{
    Plane sequential(1, false);
    sequential.checker.throwAt = 9;
    EXPECT_THROW((void)sequential.run(), std::runtime_error);
    for (const unsigned workers : {2U, 8U, 32U})
        for (const bool simulated : {false, true})
        {
            Plane parallel(workers, simulated);
            parallel.checker.throwAt = 9;
            EXPECT_THROW((void)parallel.run(), std::runtime_error);
            parallel.broker->settle();
            EXPECT_FALSE(parallel.executor->busy());
            EXPECT_EQ(parallel.search->orderHash(), sequential.search->orderHash());

            // Once the check answers, the search goes on where it was.
            parallel.checker.throwAt = -1;
            EXPECT_EQ(parallel.run(), SearchStatus::Solved);
            EXPECT_NEAR(parallel.cost(), costThroughGap(), 1e-9);
        }
}

TEST(LazySearch, AnExceptionThatIsNotNeededIsCountedAndForgotten)
{
    Plane needed(1, false);
    std::set<CheckId> demanded;
    needed.search->setObserver([&](CheckId check, bool) { demanded.insert(check); });
    ASSERT_EQ(needed.run(), SearchStatus::Solved);
    Plane plane(64, true);
    ASSERT_EQ(plane.run(), SearchStatus::Solved);
    plane.broker->settle();
    ASSERT_GT(plane.broker->statistics().speculativeWasted(), 0U);

    // The cells of one column throw, but for those that the search needs: they are told beforehand.
    Plane failing(64, true);
    failing.checker.throwAt = 13;
    for (const CheckId check : demanded)
    {
        const auto at = needed.lattice.coordinates(check.node());
        if (at[0] == 13)
            failing.broker->setVerdict(CheckId::ofState(failing.node(at[0], at[1])), true);
    }
    EXPECT_EQ(failing.run(), SearchStatus::Solved);
    failing.broker->settle();
    EXPECT_GT(failing.broker->statistics().failuresForgotten, 0U);
    EXPECT_EQ(failing.search->orderHash(), needed.search->orderHash());
}

TEST(LazySearch, AWaitIsInterruptedAndLosesNothing)
{
    Plane plane(2, false);
    plane.checker.sleep = std::chrono::milliseconds(120);
    plane.broker->setInterrupt([] { return true; });
    EXPECT_EQ(plane.run(), SearchStatus::Stopped);
    plane.broker->settle();
    EXPECT_LT(plane.search->decisions(), 8U);

    plane.checker.sleep = std::chrono::milliseconds(0);
    plane.broker->setInterrupt({});
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    Plane whole(1, false);
    EXPECT_EQ(whole.run(), SearchStatus::Solved);
    EXPECT_EQ(plane.search->orderHash(), whole.search->orderHash());
}

TEST(LazySearch, AClosedWallIsInfeasibleHoweverManyWorkers)
{
    Plane serial(1, false);
    serial.checker.gap = 0;
    EXPECT_EQ(serial.run(), SearchStatus::Infeasible);
    EXPECT_EQ(serial.search->reachedGoal(), lattice::kNoNode);
    for (const unsigned workers : {2U, 32U})
    {
        Plane parallel(workers, true);
        parallel.checker.gap = 0;
        EXPECT_EQ(parallel.run(), SearchStatus::Infeasible);
        EXPECT_EQ(parallel.search->orderHash(), serial.search->orderHash());
    }
}

TEST(LazySearch, AStartThatIsAGoalNeedsNoCheck)
{
    Plane plane(1, false, 2);
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    EXPECT_EQ(plane.checker.calls, 0);
    EXPECT_EQ(plane.cost(), 0.0);
    EXPECT_EQ(plane.search->pathTo(plane.search->reachedGoal()).size(), 1U);
}

TEST(LazySearch, TerminalsAreReachedByTheirOwnMotions)
{
    for (const unsigned workers : {1U, 8U})
    {
        Plane plane(workers, workers > 1, 20);
        const NodeId start = plane.lattice.addTerminal();
        const NodeId goal = plane.lattice.addTerminal();
        plane.lattice.connect(start, plane.node(11, 1), 0.25);
        plane.lattice.connect(plane.node(13, 1), goal, 0.5);
        plane.lattice.connect(plane.node(14, 1), goal, 0.125);
        lattice::GridHeuristic heuristic(plane.lattice, {1.0, 1.0}, 2);
        heuristic.addGoal({{13.5, 1.0}, {{0.5, 0.0}, {-0.5, 0.0}}});
        search::LazySearch search(plane.lattice, heuristic, *plane.broker);
        plane.broker->setSource(&search);
        search.addGoal(goal);
        search.addStart(start);
        EXPECT_EQ(search.run([] { return false; }), SearchStatus::Solved);
        plane.broker->settle();
        EXPECT_NEAR(search.costToCome(goal), 0.25 + 2.0 + 0.5, 1e-9);
        EXPECT_EQ(search.pathTo(goal),
                  (std::vector<NodeId>{start, plane.node(11, 1), plane.node(12, 1), plane.node(13, 1), goal}));
        EXPECT_EQ(search.parent(goal), plane.node(13, 1));
        EXPECT_EQ(search.parent(start), lattice::kNoNode);

        plane.checker.motionsValid = false;
        search::LazySearch blocked(plane.lattice, heuristic, *plane.broker);
        plane.broker->setSource(nullptr);
        const NodeId other = plane.lattice.addTerminal();
        plane.lattice.connect(start, other, 1.0);
        blocked.addGoal(other);
        blocked.addStart(start);
        EXPECT_EQ(blocked.run([] { return false; }), SearchStatus::Infeasible);
    }
}

TEST(LazySearch, TheSolutionStaysAfterAnotherRun)
{
    Plane plane(1, false);
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    const auto decisions = plane.search->decisions();
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    EXPECT_EQ(plane.search->decisions(), decisions);
}
}  // namespace
}  // namespace specplan::test
