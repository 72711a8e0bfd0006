// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "Group.h"

namespace specplan::test
{
namespace
{
using Kind = Joint::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A wall across the first value, with a gap where the second one is large.
bool wallWithGap(const double* v)
{
    return std::abs(v[0] - 1.0) > 0.2 || v[1] > 1.5;
}

std::string explanationOf(SpeculativeAStar& planner, Group& group)
{
    group.setup.setup();
    std::ostringstream out;
    planner.explain(out);
    return out.str();
}

void expectSolved(Group& group, double seconds = 20.0)
{
    ASSERT_EQ(group.setup.solve(seconds), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(group.path().check());
    EXPECT_EQ(group.counts.stale, 0);
}

TEST(JointSpace, OfRevoluteAndContinuousJointsIsPlannedInWhateverTheCheckerNotes)
{
    for (const unsigned threads : {1U, 2U, 4U})
    {
        Group group({{Kind::Revolute, 2.9}, {Kind::Revolute, 2.9}, {Kind::Continuous}}, wallWithGap);
        PlannerSettings settings;
        settings.numThreads = threads;
        settings.weight = 3.0;
        group.plan({-1.0, 0.1, 3.0}, {1.7, 0.2, -3.0}, settings);
        expectSolved(group);
        for (const ob::State* state : group.path().getStates())
            EXPECT_GT(std::abs(GroupSpace::valuesOf(state)[2]), 2.0) << "the short way round leads over pi";
    }
}

TEST(JointSpace, MimicJointsFollowAndAreNoAxes)
{
    Group group({{Kind::Revolute, 2.9}, {Kind::Mimic, kInfinity, 0, -0.5, 0.2}, {Kind::Revolute, 2.9}},
                [](const double* v) { return std::abs(v[0] - 1.0) > 0.2 || v[2] > 1.5; });
    auto& planner = group.plan({-1.0, 0.7, 0.1}, {1.8, -0.7, 0.2});
    EXPECT_NE(explanationOf(planner, group).find("2 axes"), std::string::npos);
    expectSolved(group);
    EXPECT_GT(group.path().getStateCount(), 4U);
    for (const ob::State* state : group.path().getStates())
        EXPECT_NEAR(GroupSpace::valuesOf(state)[1], -0.5 * GroupSpace::valuesOf(state)[0] + 0.2, 1e-9);
}

TEST(JointSpace, AMimicJointOfAnAngleThatComesRoundFollows)
{
    Group group({{Kind::Mimic, kInfinity, 1, 2.0, 0.0}, {Kind::Continuous}, {Kind::Revolute, 1.0}});
    group.plan({6.0, 3.0, 0.0}, {-6.0, -3.0, 0.5});
    expectSolved(group);
    for (const ob::State* state : group.path().getStates())
        EXPECT_NEAR(GroupSpace::valuesOf(state)[0], 2.0 * GroupSpace::valuesOf(state)[1], 1e-9);
}

TEST(JointSpace, AJointWithoutRoomIsAnAxisThatStandsStill)
{
    Group group({{Kind::Revolute, 0.0}, {Kind::Revolute, 1.0}});
    auto& planner = group.plan({0.0, -0.5}, {0.0, 0.5});
    EXPECT_NE(explanationOf(planner, group).find("stands still"), std::string::npos);
    expectSolved(group);
}

TEST(JointSpace, APlanarJointNeedsTheBoundsOfTheWorkspace)
{
    Group unbounded({{Kind::Planar}});
    auto& refused = unbounded.plan({0.0, 0.0, 0.0}, {1.0, 1.0, 2.0});
    EXPECT_EQ(unbounded.setup.solve(5.0), ob::PlannerStatus::CRASH);
    EXPECT_NE(refused.getReport().error.find("no bounds for its value 0"), std::string::npos)
        << refused.getReport().error;
    EXPECT_NE(refused.getReport().error.find("workspace"), std::string::npos);
    EXPECT_NE(refused.getReport().error.find("setLatticeAxes"), std::string::npos);

    Group bounded({{Kind::Planar, 2.0}}, [](const double* v) { return std::abs(v[0]) > 0.2 || v[1] > 1.0; });
    auto& planner = bounded.plan({-1.0, 0.0, 3.0}, {1.0, 0.0, -3.0});
    EXPECT_NE(explanationOf(planner, bounded).find("wraps around"), std::string::npos);
    expectSolved(bounded);
}

/// Places and heading of a floating base that stays upright.
LatticeAxes uprightBase(double bound)
{
    LatticeAxes axes;
    for (const char* name : {"x", "y", "z"})
        axes.axes.push_back({name, -bound, bound, false, false, -1});
    axes.axes.push_back({"heading", -kPi, kPi, true, false, -1});
    axes.read = [](const ob::State* state, double* values)
    {
        const double* v = GroupSpace::valuesOf(state);
        std::copy_n(v, 3, values);
        values[3] = std::remainder(2.0 * std::atan2(v[5], v[6]), 2.0 * kPi);
    };
    axes.write = [](const double* values, ob::State* state)
    {
        double* v = GroupSpace::valuesOf(state);
        std::copy_n(values, 3, v);
        v[3] = v[4] = 0.0;
        v[5] = std::sin(values[3] / 2.0);
        v[6] = std::cos(values[3] / 2.0);
    };
    return axes;
}

TEST(JointSpace, AFloatingJointIsRefusedWithTheReasonAndPlannedInOnceDescribed)
{
    const auto pillar = [](const double* v) { return std::hypot(v[0], v[1]) > 0.3; };
    Group group({{Kind::Floating, 1.0}}, pillar);
    const Group::State start{-0.8, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    const Group::State goal{0.8, 0.0, 0.5, 0.0, 0.0, std::sin(1.0), std::cos(1.0)};
    auto& planner = group.plan(start, goal);
    EXPECT_EQ(group.setup.solve(5.0), ob::PlannerStatus::CRASH);
    EXPECT_NE(planner.getReport().error.find("depend on each other"), std::string::npos) << planner.getReport().error;
    EXPECT_NE(planner.getReport().error.find("setLatticeAxes"), std::string::npos);

    planner.setLatticeAxes(uprightBase(1.0));
    EXPECT_NE(explanationOf(planner, group).find("heading: -3.14159 to 3.14159, wraps around"), std::string::npos);
    group.setup.getProblemDefinition()->clearSolutionPaths();
    expectSolved(group);
    EXPECT_TRUE(group.space->equalStates(group.path().getStates().back(), group.state(goal).get()));

    planner.setLatticeAxes({});
    group.setup.getProblemDefinition()->clearSolutionPaths();
    EXPECT_EQ(group.setup.solve(5.0), ob::PlannerStatus::CRASH) << "what was said is taken back";
}

TEST(JointSpace, OneJointBesideAFloatingOneIsDescribedByItsNumber)
{
    Group group({{Kind::Floating, 1.0}, {Kind::Revolute, 1.0}, {Kind::Continuous}});
    auto& planner = group.plan({0, 0, 0, 0, 0, 0, 1, -0.5, 3.0}, {0, 0, 0, 0, 0, 0, 1, 0.5, -3.0});
    LatticeAxes axes;
    axes.axes.push_back({"lift", -1.0, 1.0, false, false, 7});
    axes.axes.push_back({"wrist", -kPi, kPi, true, false, 8});
    planner.setLatticeAxes(axes);
    expectSolved(group);
    for (const ob::State* state : group.path().getStates())
        EXPECT_DOUBLE_EQ(GroupSpace::valuesOf(state)[6], 1.0) << "other values are those of the start";
}

TEST(JointSpace, CountsTheChecksOfThePathOnceMore)
{
    Group group({{Kind::Revolute, 2.9}, {Kind::Revolute, 2.9}}, wallWithGap);
    PlannerSettings settings;
    settings.numThreads = 1;
    auto& planner = group.plan({-1.0, 0.1}, {1.7, 0.2}, settings);
    group.setup.setup();
    ASSERT_EQ(planner.ob::Planner::solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
    const auto& report = planner.getReport();
    EXPECT_GE(report.pathChecks, group.path().getStateCount());
    const std::uint64_t before = report.pathChecks;
    ASSERT_EQ(planner.ob::Planner::solve(1.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(report.pathChecks, before) << "once for each path";
}
}  // namespace
}  // namespace specplan::test
