// SPDX-License-Identifier: BSD-3-Clause
// What no lattice can be made of is refused, with the reason.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/lattice/PrimitiveFactor.h"
#include "specplan/lattice/RotationFactor.h"

namespace specplan::lattice
{
namespace
{
void expectRefused(const std::function<void()>& make, const std::string& reason)
{
    try
    {
        make();
        ADD_FAILURE() << "not refused: " << reason;
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
}

GridSteps steps()
{
    GridSteps made;
    made.connectivity = 1;
    made.cost = [](std::span<const Coordinate>) { return 1.0; };
    return made;
}

TEST(Refusal, Grids)
{
    expectRefused([] { GridNeighbourhood({{0, 5}, {9, 4}}, steps()); }, "the grid is empty along axis 1");
    GridSteps still = steps();
    still.stride = 0;
    expectRefused([&] { GridNeighbourhood({{0, 0}, {9, 9}}, still); }, "the stride of a grid must be at least 1");
    GridSteps free = steps();
    free.cost = [](std::span<const Coordinate>) { return 0.0; };
    expectRefused(
        [&] {
            GridNeighbourhood({{0, 0}, {9, 9}}, free);
        },
        "every step of a grid needs a finite cost greater than 0");
    GridSteps around = steps();
    around.connectivity = 13;
    around.cornerCutting = false;
    expectRefused(
        [&] {
            GridNeighbourhood({std::vector<Coordinate>(13, 0), std::vector<Coordinate>(13, 1)}, around);
        },
        "a node has more than 65536 neighbours; choose a smaller connectivity");
}

TEST(Refusal, RotationsAndMotionPrimitives)
{
    expectRefused([] { RotationGrid(0); }, "a grid of rotations needs a size of at least 1");
    const RotationGrid grid(4);
    expectRefused([&] { RotationFactor(grid, 3, 1, 1.0, 0.1); },
                  "the stride of a grid of rotations has to divide its size");
    expectRefused([] { PrimitiveFactor({}, {{}}); }, "heading 0 has no motions");
}
}  // namespace
}  // namespace specplan::lattice
