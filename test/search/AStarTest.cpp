// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/AStar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "Plane.h"
#include "specplan/speculation/DirectionPolicy.h"

namespace specplan::test
{
namespace
{
using lattice::CheckId;
using lattice::Coordinate;
using search::SearchStatus;

/// A* on the open plane.
struct AStarOnPlane : Plane
{
    explicit AStarOnPlane(unsigned workers, bool simulated, Coordinate goalX = 20)
        : Plane(workers, simulated, goalX), policy(lattice, *broker, 6), search(lattice, heuristic, *broker, 1.0)
    {
        broker->setSource(&policy);
        search.setPolicy(&policy);
        search.addGoal(node(goalX, 15));
        search.addStart(node(2, 15));
    }

    SearchStatus run()
    {
        return search.run([] { return false; });
    }

    speculation::DirectionPolicy policy;
    search::AStar search;
};

TEST(AStar, StopIsAskedOncePerExpansionAndTheSearchGoesOn)
{
    AStarOnPlane whole(1, false);
    ASSERT_EQ(whole.run(), SearchStatus::Solved);

    AStarOnPlane stopped(1, false);
    int asked = 0;
    int rounds = 0;
    SearchStatus status = SearchStatus::Stopped;
    while (status == SearchStatus::Stopped)
    {
        ++rounds;
        int allowed = 5;
        status = stopped.search.run(
            [&]
            {
                ++asked;
                return allowed-- == 0;
            });
    }
    EXPECT_EQ(status, SearchStatus::Solved);
    EXPECT_EQ(static_cast<std::uint64_t>(asked), stopped.search.expansions() + static_cast<std::uint64_t>(rounds) - 1);
    EXPECT_EQ(stopped.search.orderHash(), whole.search.orderHash());
    EXPECT_EQ(stopped.checker.calls, whole.checker.calls);
}

TEST(AStar, AnExceptionThatIsNeededSurfacesWithTheSameExpansionsEverywhere)
{
    AStarOnPlane sequential(1, false);
    sequential.checker.throwAt = 9;
    EXPECT_THROW((void)sequential.run(), std::runtime_error);
    for (const unsigned workers : {2U, 8U, 32U})
        for (const bool simulated : {false, true})
        {
            AStarOnPlane parallel(workers, simulated);
            parallel.checker.throwAt = 9;
            EXPECT_THROW((void)parallel.run(), std::runtime_error);
            parallel.broker->settle();
            EXPECT_FALSE(parallel.executor->busy());
            EXPECT_EQ(parallel.search.orderHash(), sequential.search.orderHash());
            EXPECT_EQ(parallel.search.expansions(), sequential.search.expansions());

            // Once the check answers, the search goes on where it was.
            parallel.checker.throwAt = -1;
            EXPECT_EQ(parallel.run(), SearchStatus::Solved);
            EXPECT_DOUBLE_EQ(parallel.search.costToCome(parallel.search.reachedGoal()), 18.0);
        }
}

TEST(AStar, AnExceptionThatIsNotNeededIsCountedAndForgotten)
{
    AStarOnPlane plane(32, true, 7);
    plane.checker.throwAt = 10;  // beyond the goal's neighbours, within the look-ahead
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    plane.broker->settle();
    EXPECT_GT(plane.broker->statistics().failuresForgotten, 0U);
}

TEST(AStar, ALongExpansionIsInterruptedBetweenChecksAndLosesNothing)
{
    for (const unsigned workers : {1U, 2U})
    {
        AStarOnPlane plane(workers, false);
        plane.checker.sleep = std::chrono::milliseconds(60);
        bool stop = false;
        plane.broker->setInterrupt([&] { return stop = true; });
        EXPECT_EQ(plane.search.run([] { return false; }), SearchStatus::Stopped);
        plane.broker->settle();
        EXPECT_TRUE(stop);
        EXPECT_LT(plane.checker.calls, 8);  // the first expansion alone needs 8 checks
        EXPECT_EQ(plane.search.expansions(), 0U);

        plane.checker.sleep = std::chrono::milliseconds(0);
        plane.broker->setInterrupt({});
        EXPECT_EQ(plane.run(), SearchStatus::Solved);
        AStarOnPlane whole(1, false);
        EXPECT_EQ(whole.run(), SearchStatus::Solved);
        EXPECT_EQ(plane.search.orderHash(), whole.search.orderHash());
    }
}

TEST(AStar, TheSolutionStaysAfterAnotherRun)
{
    AStarOnPlane plane(1, false);
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    const auto expansions = plane.search.expansions();
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    EXPECT_EQ(plane.search.expansions(), expansions);
}
}  // namespace
}  // namespace specplan::test
