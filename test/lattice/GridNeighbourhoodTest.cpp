// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/GridNeighbourhood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace specplan::lattice
{
namespace
{
using Row = std::vector<Coordinate>;

GridSteps euclidean(unsigned connectivity)
{
    GridSteps steps;
    steps.connectivity = connectivity;
    steps.cost = [](std::span<const Coordinate> offset)
    {
        double squared = 0.0;
        for (const Coordinate axis : offset)
            squared += axis * axis;
        return std::sqrt(squared);
    };
    return steps;
}

std::vector<Row> endsOf(const GridNeighbourhood& grid, const Row& from)
{
    Steps steps;
    grid.steps(from.data(), steps);
    std::vector<Row> ends;
    for (std::size_t i = 0; i < steps.count; ++i)
        ends.emplace_back(steps.ends.begin() + static_cast<std::ptrdiff_t>(i * from.size()),
                          steps.ends.begin() + static_cast<std::ptrdiff_t>((i + 1) * from.size()));
    return ends;
}

TEST(GridNeighbourhood, HasAsManyStepsAsTheConnectivityGives)
{
    const struct
    {
        std::size_t dimension;
        unsigned connectivity;
        std::size_t steps;
    } cases[] = {{1, 1, 2}, {2, 1, 4}, {2, 2, 8}, {3, 1, 6}, {3, 2, 18}, {3, 3, 26}, {6, 2, 72}, {7, 2, 98}};
    for (const auto& [dimension, connectivity, expected] : cases)
    {
        const GridNeighbourhood grid({Row(dimension, -1), Row(dimension, 1)}, euclidean(connectivity));
        const auto ends = endsOf(grid, Row(dimension, 0));
        EXPECT_EQ(ends.size(), expected);
        EXPECT_EQ(std::set<Row>(ends.begin(), ends.end()).size(), expected) << "no step twice";
        EXPECT_EQ(grid.maxSteps(), expected);
    }
}

TEST(GridNeighbourhood, StaysInsideTheBoxAndKeepsNumbersOfSteps)
{
    const GridNeighbourhood grid({{0, 0}, {2, 2}}, euclidean(2));
    Steps inside;
    grid.steps(Row{1, 1}.data(), inside);
    std::vector<Steps::Step> all(inside.steps.begin(), inside.steps.begin() + 8);
    Steps corner;
    grid.steps(Row{2, 0}.data(), corner);
    ASSERT_EQ(corner.count, 3U);
    for (std::size_t i = 0; i < corner.count; ++i)
    {
        const Row end(corner.ends.begin() + static_cast<std::ptrdiff_t>(2 * i),
                      corner.ends.begin() + static_cast<std::ptrdiff_t>(2 * i + 2));
        EXPECT_TRUE(grid.contains(end.data()));
        const Steps::Step& same = all[corner.steps[i].index];
        EXPECT_EQ(same.cost, corner.steps[i].cost) << "the same index means the same direction everywhere";
        EXPECT_NEAR(corner.steps[i].cost, std::hypot(end[0] - 2, end[1]), 1e-15);
    }
}

TEST(GridNeighbourhood, WithoutCornerCuttingDiagonalsAreGuardedByTheCornersOfTheirBox)
{
    GridSteps steps = euclidean(3);
    steps.cornerCutting = false;
    const GridNeighbourhood grid({{0, 0, 0}, {9, 9, 9}}, steps);
    Steps out;
    const Row from{5, 5, 5};
    grid.steps(from.data(), out);
    for (std::size_t i = 0; i < out.count; ++i)
    {
        std::size_t changed = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            changed += out.ends[3 * i + axis] != from[axis] ? 1 : 0;
        const std::vector<std::uint32_t>& guards = grid.patterns()[out.steps[i].index].guards;
        ASSERT_EQ(guards.size(), (1U << changed) - 2U);
        EXPECT_EQ(std::set<std::uint32_t>(guards.begin(), guards.end()).size(), guards.size());
        for (const std::uint32_t guard : guards)  // nothing is missing in the middle: the index is the place
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_TRUE(out.ends[3 * guard + axis] == from[axis] ||
                            out.ends[3 * guard + axis] == out.ends[3 * i + axis]);
    }
}

TEST(GridNeighbourhood, AsksForMotionChecksWhereToldTo)
{
    GridSteps steps = euclidean(2);
    steps.motionCheck = [](std::span<const Coordinate> offset) { return offset[0] != 0 && offset[1] != 0; };
    const GridNeighbourhood grid({{-1, -1}, {1, 1}}, steps);
    EXPECT_TRUE(grid.hasMotionChecks());
    EXPECT_FALSE(GridNeighbourhood({{-1, -1}, {1, 1}}, euclidean(2)).hasMotionChecks());
    Steps out;
    grid.steps(Row{0, 0}.data(), out);
    for (std::size_t i = 0; i < out.count; ++i)
        EXPECT_EQ(out.steps[i].motionCheck, out.steps[i].cost > 1.0);
}

TEST(GridNeighbourhood, GoesOnStraight)
{
    const GridNeighbourhood grid({{0, 0}, {4, 4}}, euclidean(2));
    Row next(2);
    EXPECT_TRUE(grid.goOn(Row{1, 1}.data(), Row{2, 1}.data(), next.data()));
    EXPECT_EQ(next, (Row{3, 1}));
    EXPECT_FALSE(grid.goOn(Row{3, 3}.data(), Row{4, 4}.data(), next.data())) << "leaves the box";
    EXPECT_FALSE(grid.goOn(Row{0, 0}.data(), Row{2, 0}.data(), next.data())) << "that is no step";
}

TEST(GridNeighbourhood, RefusesWhatMakesNoSense)
{
    EXPECT_THROW(GridNeighbourhood({{}, {}}, euclidean(1)), std::invalid_argument);
    EXPECT_THROW(GridNeighbourhood({{0}, {1, 1}}, euclidean(1)), std::invalid_argument);
    EXPECT_THROW(GridNeighbourhood({{1}, {0}}, euclidean(1)), std::invalid_argument);
    EXPECT_THROW(GridNeighbourhood({{0, 0}, {1, 1}}, euclidean(0)), std::invalid_argument);
    EXPECT_THROW(GridNeighbourhood({{0, 0}, {1, 1}}, euclidean(3)), std::invalid_argument);
    EXPECT_THROW(GridNeighbourhood({Row(12, 0), Row(12, 1)}, euclidean(12)), std::invalid_argument);
    for (const double cost : {0.0, -1.0, std::nan(""), HUGE_VAL})
    {
        GridSteps steps = euclidean(1);
        steps.cost = [cost](std::span<const Coordinate>) { return cost; };
        EXPECT_THROW(GridNeighbourhood({{0}, {1}}, steps), std::invalid_argument);
    }
}
}  // namespace
}  // namespace specplan::lattice
