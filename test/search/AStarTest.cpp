// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/AStar.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "RandomProblem.h"
#include "specplan/speculation/DirectionPolicy.h"
#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::test
{
namespace
{
using lattice::CheckId;
using lattice::Coordinate;
using search::SearchStatus;

/// Open plane of 30 × 30 cells; checks of some cells throw or last.
class PlaneChecker : public validity::Checker
{
public:
    explicit PlaneChecker(const lattice::Lattice& lattice) : lattice_(lattice)
    {
    }

    bool check(CheckId check, unsigned) override
    {
        ++calls;
        const Coordinate x = lattice_.coordinates(check.node())[0];
        if (sleep.count() > 0)
            std::this_thread::sleep_for(sleep);
        if (x == throwAt)
            throw std::runtime_error("no answer for x = " + std::to_string(x));
        return true;
    }

    std::atomic<int> calls{0};
    Coordinate throwAt = -1;
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
        policy = std::make_unique<speculation::DirectionPolicy>(lattice, *broker, 6);
        broker->setSource(policy.get());
        search = std::make_unique<search::AStar>(lattice, heuristic, *broker, 1.0);
        search->setPolicy(policy.get());
        heuristic.addGoal({{static_cast<double>(goalX), 15.0}, {}});
        const Coordinate start[] = {2, 15};
        const Coordinate goal[] = {goalX, 15};
        search->addGoal(lattice.node(goal));
        search->addStart(lattice.node(start));
    }

    SearchStatus run()
    {
        return search->run([] { return false; });
    }

    lattice::Lattice lattice;
    PlaneChecker checker;
    lattice::GridHeuristic heuristic;
    std::unique_ptr<validity::Executor> executor;
    std::unique_ptr<validity::Broker> broker;
    std::unique_ptr<speculation::DirectionPolicy> policy;
    std::unique_ptr<search::AStar> search;
};

TEST(AStar, StopIsAskedOncePerExpansionAndTheSearchGoesOn)
{
    Plane whole(1, false);
    ASSERT_EQ(whole.run(), SearchStatus::Solved);

    Plane stopped(1, false);
    int asked = 0;
    int rounds = 0;
    SearchStatus status = SearchStatus::Stopped;
    while (status == SearchStatus::Stopped)
    {
        ++rounds;
        int allowed = 5;
        status = stopped.search->run(
            [&]
            {
                ++asked;
                return allowed-- == 0;
            });
    }
    EXPECT_EQ(status, SearchStatus::Solved);
    EXPECT_EQ(static_cast<std::uint64_t>(asked), stopped.search->expansions() + static_cast<std::uint64_t>(rounds) - 1);
    EXPECT_EQ(stopped.search->orderHash(), whole.search->orderHash());
    EXPECT_EQ(stopped.checker.calls, whole.checker.calls);
}

TEST(AStar, AnExceptionThatIsNeededSurfacesWithTheSameExpansionsEverywhere)
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
            EXPECT_EQ(parallel.search->expansions(), sequential.search->expansions());

            // Once the check answers, the search goes on where it was.
            parallel.checker.throwAt = -1;
            EXPECT_EQ(parallel.run(), SearchStatus::Solved);
            EXPECT_DOUBLE_EQ(parallel.search->costToCome(parallel.search->reachedGoal()), 18.0);
        }
}

TEST(AStar, AnExceptionThatIsNotNeededIsCountedAndForgotten)
{
    Plane plane(32, true, 7);
    plane.checker.throwAt = 10;  // beyond the goal's neighbours, within the look-ahead
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    plane.broker->settle();
    EXPECT_GT(plane.broker->statistics().failuresForgotten, 0U);
}

TEST(AStar, ALongExpansionIsInterruptedBetweenChecksAndLosesNothing)
{
    for (const unsigned workers : {1U, 2U})
    {
        Plane plane(workers, false);
        plane.checker.sleep = std::chrono::milliseconds(60);
        bool stop = false;
        plane.broker->setInterrupt([&] { return stop = true; });
        EXPECT_EQ(plane.search->run([] { return false; }), SearchStatus::Stopped);
        plane.broker->settle();
        EXPECT_TRUE(stop);
        EXPECT_LT(plane.checker.calls, 8);  // the first expansion alone needs 8 checks
        EXPECT_EQ(plane.search->expansions(), 0U);

        plane.checker.sleep = std::chrono::milliseconds(0);
        plane.broker->setInterrupt({});
        EXPECT_EQ(plane.run(), SearchStatus::Solved);
        Plane whole(1, false);
        EXPECT_EQ(whole.run(), SearchStatus::Solved);
        EXPECT_EQ(plane.search->orderHash(), whole.search->orderHash());
    }
}

TEST(AStar, TheSolutionStaysAfterAnotherRun)
{
    Plane plane(1, false);
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    const auto expansions = plane.search->expansions();
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    EXPECT_EQ(plane.search->expansions(), expansions);
}
}  // namespace
}  // namespace specplan::test
