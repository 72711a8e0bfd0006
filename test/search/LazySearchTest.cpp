// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/AStar.h"
#include "specplan/search/LazySearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include "Plane.h"
#include "specplan/util/Hash.h"

namespace specplan::test
{
namespace
{
using lattice::CheckId;
using lattice::Coordinate;
using lattice::NodeId;
using search::SearchStatus;

/// The lazy search on the plane with its wall.
struct LazyOnPlane : Plane
{
    explicit LazyOnPlane(unsigned workers, bool simulated, Coordinate goalX = 20)
        : Plane(workers, simulated, goalX), search(lattice, heuristic, *broker)
    {
        checker.gap = 3;
        broker->setSource(&search);
        search.addGoal(node(goalX, 15));
        search.addStart(node(2, 15));
    }

    SearchStatus run()
    {
        return search.run([] { return false; });
    }

    [[nodiscard]] double cost() const
    {
        return search.costToCome(search.reachedGoal());
    }

    search::LazySearch search;
};

/// From (2, 15) up to the gap at y = 2 and down again, along diagonals where possible.
double costThroughGap()
{
    return (10.0 * std::sqrt(2.0) + 3.0) + (8.0 * std::sqrt(2.0) + 5.0);
}

TEST(LazySearch, StopIsAskedBetweenDecisionsAndTheSearchGoesOn)
{
    LazyOnPlane whole(1, false);
    ASSERT_EQ(whole.run(), SearchStatus::Solved);
    EXPECT_NEAR(whole.cost(), costThroughGap(), 1e-9);

    LazyOnPlane stopped(1, false);
    int rounds = 0;
    SearchStatus status = SearchStatus::Stopped;
    while (status == SearchStatus::Stopped)
    {
        const std::uint64_t before = stopped.search.decisions();
        int allowed = 2;
        status = stopped.search.run([&] { return allowed-- == 0; });
        EXPECT_LE(stopped.search.decisions() - before, 2U);
        ASSERT_LT(++rounds, 1000);
    }
    EXPECT_EQ(status, SearchStatus::Solved);
    EXPECT_GT(rounds, 5);
    EXPECT_EQ(stopped.search.orderHash(), whole.search.orderHash());
    EXPECT_EQ(stopped.checker.calls, whole.checker.calls);
}

TEST(LazySearch, NeedsFewerChecksThanAStarForTheSameCost)
{
    LazyOnPlane lazy(1, false);
    ASSERT_EQ(lazy.run(), SearchStatus::Solved);
    LazyOnPlane eager(1, false);
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
    LazyOnPlane serial(1, false);
    ASSERT_EQ(serial.run(), SearchStatus::Solved);
    for (const auto& [workers, speedup] : {std::pair{2U, 1.3}, {4U, 2.5}, {16U, 4.5}})
    {
        LazyOnPlane parallel(workers, true);
        ASSERT_EQ(parallel.run(), SearchStatus::Solved);
        parallel.broker->settle();
        EXPECT_EQ(parallel.search.orderHash(), serial.search.orderHash());
        EXPECT_EQ(parallel.search.decisions(), serial.search.decisions());
        EXPECT_LT(parallel.broker->now() * speedup, static_cast<double>(serial.broker->statistics().checksUsed));
    }
}

/// Nobody runs ahead: what one decision asks for runs at the same time.
TEST(LazySearch, ADecisionAsksForSeveralChecksAndForNoneInVain)
{
    std::uint64_t checks = 0;
    double time = 0.0;
    for (const unsigned workers : {1U, 16U})
    {
        LazyOnPlane lazy(workers, true);
        lazy.broker->setSource(nullptr);
        ASSERT_EQ(lazy.run(), SearchStatus::Solved);
        const validity::CheckStatistics& statistics = lazy.broker->statistics();
        EXPECT_EQ(statistics.checksUsed, statistics.checksRun);
        EXPECT_LT(2 * lazy.search.decisions(), statistics.checksUsed);
        if (workers > 1)
        {
            EXPECT_EQ(statistics.checksUsed, checks);
            EXPECT_LT(2.0 * lazy.broker->now(), time);
        }
        checks = statistics.checksUsed;
        time = lazy.broker->now();
    }
}

TEST(LazySearch, WhatIsAtHandIsUnknownAndWhatTheSearchAsksForNext)
{
    LazyOnPlane lazy(1, false);
    lazy.broker->setSource(nullptr);
    std::size_t named = 0;
    std::size_t asked = 0;
    std::size_t unnamed = 0;
    std::size_t first = 0;  // checks of the first decision, for which nobody was asked
    std::vector<CheckId> atHand;
    lazy.search.setObserver([&](CheckId check, bool)
                            { ++(std::ranges::find(atHand, check) != atHand.end() ? asked : unnamed); });
    for (int rounds = 0; rounds < 1000; ++rounds)
    {
        int allowed = 1;
        if (lazy.search.run([&] { return allowed-- == 0; }) == SearchStatus::Solved)
            break;
        first = rounds == 0 ? unnamed : first;
        atHand.clear();
        lazy.search.proposeAtHand(3, atHand);
        EXPECT_LE(atHand.size(), 3U);
        lazy.search.proposeAtHand(100, atHand);
        named += atHand.size();
        EXPECT_EQ(std::set<CheckId>(atHand.begin(), atHand.end()).size(), atHand.size());
        for (const CheckId check : atHand)
            EXPECT_EQ(lazy.broker->verdict(check), validity::Verdict::Unknown);
    }
    EXPECT_GT(first, 0U);
    EXPECT_EQ(unnamed, first);
    EXPECT_GT(asked, 2 * first);
    EXPECT_LE(asked, named);
}

/// Answers for a field where every third state is invalid, without order.
class FieldChecker : public validity::Checker
{
public:
    explicit FieldChecker(const lattice::Lattice& lattice) : lattice_(lattice)
    {
    }

    bool check(CheckId check, unsigned) override
    {
        return util::hashCoordinates(lattice_.coordinates(check.node())) % 3 != 0;
    }

private:
    const lattice::Lattice& lattice_;
};

/// The lazy search in that field.
template <typename Executor>
struct LazyInField
{
    LazyInField()
    {
        heuristic.addGoal({{195.0, 100.0, 100.0}, {}});
        search.addStart(node(5, 100, 100));
        search.addGoal(node(195, 100, 100));
    }

    static std::unique_ptr<lattice::GridNeighbourhood> neighbourhood()
    {
        lattice::GridSteps steps;
        steps.cost = [](std::span<const Coordinate> offset) { return std::hypot(offset[0], offset[1], offset[2]); };
        return std::make_unique<lattice::GridNeighbourhood>(lattice::GridBox{{0, 0, 0}, {199, 199, 199}}, steps);
    }

    NodeId node(Coordinate x, Coordinate y, Coordinate z)
    {
        const Coordinate cell[] = {x, y, z};
        return lattice.node(cell);
    }

    void decide(std::uint64_t decisions)
    {
        const std::uint64_t end = search.decisions() + decisions;
        ASSERT_EQ(search.run([&] { return search.decisions() >= end; }), SearchStatus::Stopped);
    }

    lattice::Lattice lattice{neighbourhood()};
    lattice::GridHeuristic heuristic{lattice, {1.0, 1.0, 1.0}, 3};
    FieldChecker checker{lattice};
    Executor executor{checker};
    validity::Broker broker{executor};
    search::LazySearch search{lattice, heuristic, broker};
};

TEST(LazySearch, AtHandIsAlsoWhatIsDoubtfulFarBehindTheFrontOfOpen)
{
    LazyInField<validity::InlineExecutor> field;
    const auto atHand = [&field]
    {
        constexpr std::size_t kAll = 100000;
        std::vector<CheckId> named;
        field.search.proposeAtHand(kAll, named);
        return std::set<CheckId>(named.begin(), named.end());
    };
    field.decide(1000);
    std::set<CheckId> named = atHand();
    const std::size_t first = named.size();
    EXPECT_GT(first, 100U);
    for (int decisions = 0; decisions < 5; ++decisions)
    {
        field.decide(1);
        named.merge(atHand());
    }
    EXPECT_GT(named.size(), first + 50) << "for each decision others, of those behind the front";
}

/// Says that workers have run dry, as often as it is asked.
struct DryExecutor : validity::InlineExecutor
{
    using InlineExecutor::InlineExecutor;

    [[nodiscard]] bool runsDry() override
    {
        return true;
    }
};

TEST(LazySearch, ThinkingEndsWithTheNextDecisionWhenWorkersHaveRunDry)
{
    constexpr std::size_t kMany = 1000;
    LazyInField<validity::InlineExecutor> patient;
    LazyInField<DryExecutor> hurried;
    patient.decide(100);
    hurried.decide(100);
    ASSERT_EQ(patient.search.orderHash(), hurried.search.orderHash());
    std::vector<CheckId> all;
    patient.search.propose(kMany, all);
    std::vector<CheckId> some;
    for (int calls = 0; calls < 1000 && some.empty(); ++calls)
        hurried.search.propose(kMany, some);
    ASSERT_FALSE(some.empty());
    EXPECT_LT(some.size(), 65U) << "one decision at most";
    ASSERT_GT(all.size(), 2 * some.size());
    EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin()));

    // It goes on from there, and what was guessed in pieces is worth as much.
    while (hurried.search.decisions() < 300)
    {
        some.clear();
        hurried.search.propose(kMany, some);
        hurried.decide(1);
    }
    patient.decide(200);
    EXPECT_EQ(patient.search.orderHash(), hurried.search.orderHash());
}

/// All states are valid; motions into the column x = 12 are not, but for those at y < 3.
class CrossingChecker : public validity::Checker
{
public:
    explicit CrossingChecker(const lattice::Lattice& lattice) : lattice_(lattice)
    {
    }

    bool check(CheckId check, unsigned) override
    {
        if (!check.isMotion())
            return true;
        ++(lattice_.isGlance(check.motion()) ? glances : motions);
        const auto to = lattice_.coordinates(lattice_.motion(check.motion()).to);
        return to[0] != 12 || to[1] < 3;
    }

    int glances = 0;
    int motions = 0;

private:
    const lattice::Lattice& lattice_;
};

TEST(LazySearch, AMotionThatAGlanceRefusesIsNotChecked)
{
    double cost = 0.0;
    int unseen = 0;  // motions checked without glances
    for (const bool glances : {false, true})
    {
        lattice::GridSteps steps = Plane::steps();
        steps.motionCheck = [](std::span<const Coordinate>) { return true; };
        lattice::Lattice lattice(
            std::make_unique<lattice::GridNeighbourhood>(lattice::GridBox{{0, 0}, {29, 29}}, steps));
        lattice.setGlances(glances);
        lattice::GridHeuristic heuristic(lattice, {1.0, 1.0}, 2);
        heuristic.addGoal({{20.0, 15.0}, {}});
        CrossingChecker checker(lattice);
        validity::InlineExecutor executor(checker);
        validity::Broker broker(executor);
        search::LazySearch search(lattice, heuristic, broker);
        search.setGlances([](const lattice::Lattice::Motion&) { return true; });
        const auto node = [&lattice](Coordinate x, Coordinate y)
        {
            const Coordinate cell[] = {x, y};
            return lattice.node(cell);
        };
        search.addGoal(node(20, 15));
        search.addStart(node(2, 15));
        ASSERT_EQ(search.run([] { return false; }), SearchStatus::Solved);
        if (!glances)
        {
            cost = search.costToCome(search.reachedGoal());
            unseen = checker.motions;
            EXPECT_EQ(checker.glances, 0);
            continue;
        }
        EXPECT_EQ(search.costToCome(search.reachedGoal()), cost);
        EXPECT_NEAR(cost, costThroughGap(), 1e-9);
        EXPECT_EQ(checker.motions, static_cast<int>(search.pathTo(search.reachedGoal()).size()) - 1)
            << "those of the path and no others";
        EXPECT_GT(checker.glances, checker.motions);
        EXPECT_LT(3 * checker.motions, unseen);
    }
}

TEST(LazySearch, AnExceptionThatIsNeededSurfacesAfterTheSameDecisionsEverywhere)
{
    LazyOnPlane sequential(1, false);
    sequential.checker.throwAt = 9;
    EXPECT_THROW((void)sequential.run(), std::runtime_error);
    for (const unsigned workers : {2U, 8U, 32U})
        for (const bool simulated : {false, true})
        {
            LazyOnPlane parallel(workers, simulated);
            parallel.checker.throwAt = 9;
            EXPECT_THROW((void)parallel.run(), std::runtime_error);
            parallel.broker->settle();
            EXPECT_FALSE(parallel.executor->busy());
            EXPECT_EQ(parallel.search.orderHash(), sequential.search.orderHash());

            // Once the check answers, the search goes on where it was.
            parallel.checker.throwAt = -1;
            EXPECT_EQ(parallel.run(), SearchStatus::Solved);
            EXPECT_NEAR(parallel.cost(), costThroughGap(), 1e-9);
        }
}

TEST(LazySearch, AnExceptionThatIsNotNeededIsCountedAndForgotten)
{
    LazyOnPlane needed(1, false);
    std::set<CheckId> demanded;
    needed.search.setObserver([&](CheckId check, bool) { demanded.insert(check); });
    ASSERT_EQ(needed.run(), SearchStatus::Solved);
    LazyOnPlane plane(64, true);
    ASSERT_EQ(plane.run(), SearchStatus::Solved);
    plane.broker->settle();
    ASSERT_GT(plane.broker->statistics().speculativeWasted(), 0U);

    // The cells of one column throw, but for those that the search needs: they are told beforehand.
    LazyOnPlane failing(64, true);
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
    EXPECT_EQ(failing.search.orderHash(), needed.search.orderHash());
}

TEST(LazySearch, AWaitIsInterruptedAndLosesNothing)
{
    LazyOnPlane plane(2, false);
    plane.checker.sleep = std::chrono::milliseconds(120);
    plane.broker->setInterrupt([] { return true; });
    EXPECT_EQ(plane.run(), SearchStatus::Stopped);
    plane.broker->settle();
    EXPECT_LT(plane.search.decisions(), 8U);

    plane.checker.sleep = std::chrono::milliseconds(0);
    plane.broker->setInterrupt({});
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    LazyOnPlane whole(1, false);
    EXPECT_EQ(whole.run(), SearchStatus::Solved);
    EXPECT_EQ(plane.search.orderHash(), whole.search.orderHash());
}

TEST(LazySearch, AClosedWallIsInfeasibleHoweverManyWorkers)
{
    LazyOnPlane serial(1, false);
    serial.checker.gap = 0;
    EXPECT_EQ(serial.run(), SearchStatus::Infeasible);
    EXPECT_EQ(serial.search.reachedGoal(), lattice::kNoNode);
    for (const unsigned workers : {2U, 32U})
    {
        LazyOnPlane parallel(workers, true);
        parallel.checker.gap = 0;
        EXPECT_EQ(parallel.run(), SearchStatus::Infeasible);
        EXPECT_EQ(parallel.search.orderHash(), serial.search.orderHash());
    }
}

TEST(LazySearch, AStartThatIsAGoalNeedsNoCheck)
{
    LazyOnPlane plane(1, false, 2);
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    EXPECT_EQ(plane.checker.calls, 0);
    EXPECT_EQ(plane.cost(), 0.0);
    EXPECT_EQ(plane.search.pathTo(plane.search.reachedGoal()).size(), 1U);
}

TEST(LazySearch, TerminalsAreReachedByTheirOwnMotions)
{
    for (const unsigned workers : {1U, 8U})
    {
        LazyOnPlane plane(workers, workers > 1, 20);
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
    LazyOnPlane plane(1, false);
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    const auto decisions = plane.search.decisions();
    EXPECT_EQ(plane.run(), SearchStatus::Solved);
    EXPECT_EQ(plane.search.decisions(), decisions);
}
}  // namespace
}  // namespace specplan::test
