// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/Lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "specplan/lattice/GridNeighbourhood.h"

namespace specplan::lattice
{
namespace
{
using Row = std::vector<Coordinate>;

Lattice makeLattice(bool motionChecks)
{
    GridSteps steps;
    steps.connectivity = 1;
    steps.cost = [](std::span<const Coordinate>) { return 2.0; };
    steps.motionCheck = [motionChecks](std::span<const Coordinate>) { return motionChecks; };
    return Lattice(std::make_unique<GridNeighbourhood>(GridBox{{0, 0}, {4, 4}}, steps));
}

TEST(Lattice, SuccessorsComeInTheSameOrderEveryTime)
{
    Lattice lattice = makeLattice(true);
    const NodeId middle = lattice.node(Row{2, 2}.data());
    Successors first;
    lattice.successors(middle, first);
    ASSERT_EQ(first.edges.size(), 4U);
    Successors again;
    lattice.successors(middle, again);
    for (std::size_t i = 0; i < 4; ++i)
    {
        EXPECT_EQ(again.edges[i].node, first.edges[i].node);
        EXPECT_EQ(again.innerOf(again.edges[i])[0], first.innerOf(first.edges[i])[0]);
    }
}

TEST(Lattice, NeighboursAreTheEndsOfAllMotions)
{
    for (const bool motionChecks : {false, true})
    {
        Lattice lattice = makeLattice(motionChecks);
        const NodeId corner = lattice.node(Row{4, 2}.data());
        const NodeId terminal = lattice.addTerminal();
        lattice.connect(corner, terminal, 0.5);
        EXPECT_FALSE(lattice.knowsNeighbours(corner));
        std::vector<NodeId> ends;
        lattice.neighbours(corner, ends);
        EXPECT_TRUE(lattice.knowsNeighbours(corner));
        Successors successors;
        lattice.successors(corner, successors);
        std::vector<NodeId> expected;
        for (const Successors::Edge& edge : successors.edges)
            expected.push_back(edge.node);
        EXPECT_EQ(expected.size(), 4U);
        EXPECT_EQ(ends, expected) << "met for the first time";
        lattice.neighbours(corner, ends);
        EXPECT_EQ(ends, expected) << "known";
        lattice.disconnectAll();
        lattice.neighbours(corner, ends);
        expected.pop_back();
        EXPECT_EQ(ends, expected);
    }
}

TEST(Lattice, GuardsAreTheSameEveryTime)
{
    GridSteps steps;
    steps.connectivity = 2;
    steps.cornerCutting = false;
    steps.cost = [](std::span<const Coordinate>) { return 1.0; };
    Lattice lattice(std::make_unique<GridNeighbourhood>(GridBox{{0, 0}, {4, 4}}, steps));
    for (const Row& row : {Row{0, 0}, Row{2, 2}, Row{4, 1}})
    {
        const NodeId node = lattice.node(row.data());
        Successors first;
        lattice.successors(node, first);
        Successors again;
        lattice.successors(node, again);
        EXPECT_EQ(again.inner, first.inner);
        for (const Successors::Edge& edge : again.edges)
            for (const CheckId guard : again.guardsOf(edge))
            {
                // A corner of the box between the node and the end: it shares an axis with each.
                const auto corner = lattice.coordinates(guard.node());
                const auto end = lattice.coordinates(edge.node);
                EXPECT_TRUE((corner[0] == row[0] && corner[1] == end[1]) ||
                            (corner[0] == end[0] && corner[1] == row[1]));
            }
    }
}

TEST(Lattice, EveryMotionHasACheckOfItsOwnThatKnowsItsEnds)
{
    Lattice lattice = makeLattice(true);
    std::set<CheckId> checks;
    std::size_t motions = 0;
    Successors successors;
    for (Coordinate x = 0; x < 5; ++x)
        for (Coordinate y = 0; y < 5; ++y)
        {
            const NodeId node = lattice.node(Row{x, y}.data());
            lattice.successors(node, successors);
            for (const Successors::Edge& edge : successors.edges)
            {
                ASSERT_EQ(edge.inner, 1U);
                const CheckId check = successors.innerOf(edge)[0];
                ASSERT_TRUE(check.isMotion());
                EXPECT_EQ(lattice.motion(check.motion()).from, node);
                EXPECT_EQ(lattice.motion(check.motion()).to, edge.node);
                checks.insert(check);
                ++motions;
            }
        }
    EXPECT_EQ(checks.size(), motions);
    EXPECT_EQ(motions, 80U);
}

TEST(Lattice, AGlanceIsACheckOfItsOwnOfTheSameMotion)
{
    Lattice lattice = makeLattice(true);
    lattice.setGlances(true);
    const NodeId node = lattice.node(Row{1, 1}.data());
    const NodeId terminal = lattice.addTerminal();
    lattice.connect(node, terminal, 1.0);
    Successors successors;
    lattice.successors(node, successors);
    std::set<MotionId> glances;
    for (const Successors::Edge& edge : successors.edges)
    {
        const MotionId motion = successors.innerOf(edge)[0].motion();
        EXPECT_FALSE(lattice.isGlance(motion));
        EXPECT_EQ(lattice.glancedAt(motion), motion);
        const std::optional<MotionId> glance = lattice.glanceOf(motion);
        EXPECT_EQ(glance.has_value(), edge.node != terminal) << "motions made by hand have none";
        if (!glance)
            continue;
        EXPECT_TRUE(lattice.isGlance(*glance));
        EXPECT_FALSE(lattice.glanceOf(*glance));
        EXPECT_EQ(lattice.glancedAt(*glance), motion);
        EXPECT_EQ(lattice.motion(*glance).from, node);
        EXPECT_EQ(lattice.motion(*glance).to, edge.node);
        glances.insert(*glance);
    }
    EXPECT_EQ(glances.size(), 4U);
    Lattice plain = makeLattice(true);
    plain.successors(plain.node(Row{1, 1}.data()), successors);
    EXPECT_FALSE(plain.glanceOf(successors.inner.front().motion()));
}

TEST(Lattice, StepsThatComeBackKeepTheirMotions)
{
    const auto neighbourhood = [](Coordinate stride)
    {
        GridSteps steps;
        steps.stride = stride;
        steps.cost = [](std::span<const Coordinate>) { return 2.0; };
        steps.motionCheck = [](std::span<const Coordinate>) { return true; };
        return std::make_unique<GridNeighbourhood>(GridBox{{0, 0}, {8, 8}}, steps);
    };
    Lattice lattice(neighbourhood(2));
    const NodeId node = lattice.node(Row{4, 4}.data());
    Successors usual;
    lattice.successors(node, usual);
    lattice.setNeighbourhood(neighbourhood(4), -1);
    Successors coarse;
    lattice.successors(node, coarse);
    EXPECT_EQ(lattice.coordinates(coarse.edges[0].node)[0], 0);
    for (const CheckId check : coarse.inner)
        EXPECT_EQ(std::ranges::count(usual.inner, check), 0) << "other motions have other checks";
    lattice.setNeighbourhood(neighbourhood(2), 0);
    Successors again;
    lattice.successors(node, again);
    EXPECT_EQ(again.inner, usual.inner);
    lattice.setNeighbourhood(neighbourhood(4), -1);
    lattice.successors(node, again);
    EXPECT_EQ(again.inner, coarse.inner);
}

TEST(Lattice, TerminalsAreJoinedByHand)
{
    Lattice lattice = makeLattice(false);
    const NodeId first = lattice.addTerminal();
    const NodeId second = lattice.addTerminal();
    const NodeId node = lattice.node(Row{0, 0}.data());
    EXPECT_TRUE(lattice.isTerminal(first));
    EXPECT_FALSE(lattice.isTerminal(node));
    EXPECT_EQ(lattice.terminalIndex(first), 0U);
    EXPECT_EQ(lattice.terminalIndex(second), 1U);
    Successors successors;
    lattice.successors(first, successors);
    EXPECT_TRUE(successors.edges.empty());
    lattice.connect(first, node, 0.25);
    lattice.connect(node, second, 0.5);
    lattice.successors(first, successors);
    ASSERT_EQ(successors.edges.size(), 1U);
    EXPECT_EQ(successors.edges[0].node, node);
    EXPECT_EQ(successors.edges[0].cost, 0.25);
    EXPECT_TRUE(successors.innerOf(successors.edges[0])[0].isMotion());
    lattice.successors(node, successors);
    ASSERT_EQ(successors.edges.size(), 3U);
    EXPECT_EQ(successors.edges[2].node, second);
    EXPECT_FALSE(lattice.goOn(first, node).has_value());
}

TEST(Lattice, MotionCostsMayDependOnTheNodes)
{
    Lattice lattice = makeLattice(false);
    lattice.setStepCost([](NodeId, NodeId to) { return 10.0 + to; });
    Successors successors;
    lattice.successors(lattice.node(Row{0, 0}.data()), successors);
    for (const Successors::Edge& edge : successors.edges)
        EXPECT_EQ(edge.cost, 10.0 + edge.node);
}
}  // namespace
}  // namespace specplan::lattice
