// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of axes that cannot be meant.
#include <gtest/gtest.h>

#include <limits>

#include <ompl/util/Exception.h>

#include "Scene.h"
#include "specplan/planner/LatticeAxes.h"

namespace specplan::test
{
namespace
{
LatticeAxes axes(std::initializer_list<LatticeAxis> of)
{
    LatticeAxes made;
    made.axes = of;
    return made;
}

std::string refusal(const LatticeAxes& described)
{
    Scene scene;
    auto& planner = scene.plan(settingsFor(1));
    try
    {
        planner.setLatticeAxes(described);
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "";
}

/// What solve() says of a description that could be meant for another space.
std::string errorOf(const LatticeAxes& described)
{
    Scene scene;
    auto& planner = scene.plan(settingsFor(1));
    scene.space->setName("square");
    planner.setLatticeAxes(described);
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::CRASH);
    EXPECT_EQ(planner.getReport().checksTotal, 0U);
    return planner.getReport().error;
}

TEST(LatticeAxes, AreRefusedWhereTheyContradictThemselves)
{
    LatticeAxes half = axes({{"x", 0.0, 1.0, false, false, 0}});
    half.read = [](const ob::State*, double*) {};
    EXPECT_EQ(refusal(half), "lattice axes need both 'read' and 'write', or neither");
    EXPECT_EQ(refusal(axes({{"x", 0.0, 1.0, false, false, 0}, {"y", 0.0, 1.0, false, false, 0}})),
              "axis 'y' has the same value, number 0, as axis 'x'");
    EXPECT_EQ(refusal(axes({{"x", 0.0, 1.0}})),
              "axis 'x' needs 'value', its number among the values of copyToReals(), where there are no 'read' and "
              "'write'");
    EXPECT_EQ(refusal(axes({{"x", 2.0, 1.0, false, false, 0}})),
              "axis 'x' must have finite bounds, the lower one not greater than the upper one, not 2 and 1");
    LatticeAxes round = axes({{"turn", 1.0, 1.0, true, false, 0}});
    round.space = "wrist";
    EXPECT_EQ(refusal(round),
              "axis 'turn' of the space 'wrist' must have finite bounds, the lower one less than the "
              "upper one, not 1 and 1");
    EXPECT_EQ(refusal(axes({{"x", 0.0, std::numeric_limits<double>::infinity(), false, false, 0}})),
              "axis 'x' must have finite bounds, the lower one not greater than the upper one, not 0 and inf");
}

TEST(LatticeAxes, AreRefusedWhereTheyDoNotFitTheSpace)
{
    EXPECT_EQ(errorOf(axes({{"x", 0.0, 1.0, false, false, 0}, {"lift", 0.0, 1.0, false, false, 5}})),
              "axis 'lift' is said to be value 5 of copyToReals(), but the space 'square' has only 2");
    EXPECT_EQ(errorOf(axes({{"x", 0.5, 1.0, false, false, 0}, {"y", 0.0, 1.0, false, false, 1}})),
              "axis 'x' goes from 0.5 to 1, but the start has 0.1");
}
}  // namespace
}  // namespace specplan::test
