// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/RigidBodyChecker.h"

#include <gtest/gtest.h>

#include <numbers>

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "EightThreads.h"
#include "RigidFixture.h"

namespace specplan::problems
{
namespace
{
namespace ob = ompl::base;

constexpr double kPi = std::numbers::pi;

template <typename Space>
std::shared_ptr<Space> makeSpace(unsigned dimension)
{
    ob::RealVectorBounds bounds(dimension);
    bounds.setLow(-10.0);
    bounds.setHigh(20.0);
    auto space = std::make_shared<Space>();
    space->setBounds(bounds);
    return space;
}

std::shared_ptr<const RigidBodyScene> roomScene(std::size_t robots)
{
    const RigidBody robot = RigidBody().addMesh(test::boxMesh({-0.5, -0.2, -0.5}, {0.5, 0.2, 0.5}));
    return std::make_shared<const RigidBodyScene>(std::vector<RigidBody>(robots, robot),
                                                  RigidBody().addMesh(test::roomMesh()));
}

void place(ob::State* state, double x, double y, double yaw)
{
    state->as<ob::SE2StateSpace::StateType>()->setXY(x, y);
    state->as<ob::SE2StateSpace::StateType>()->setYaw(yaw);
}

TEST(RigidBodyChecker, TurnsABodyInThePlane)
{
    const auto si = std::make_shared<ob::SpaceInformation>(makeSpace<ob::SE2StateSpace>(2));
    const RigidBodyChecker checker(si, roomScene(1));
    ob::ScopedState<> state(si);
    place(state.get(), 4.5, 5.0, 0.0);
    EXPECT_FALSE(checker.isValid(state.get())) << "its end is in the wall";
    EXPECT_EQ(checker.clearance(state.get()), 0.0);
    place(state.get(), 4.5, 5.0, kPi / 2.0);
    EXPECT_TRUE(checker.isValid(state.get()));
    EXPECT_NEAR(checker.clearance(state.get()), 0.2, 1e-6);
}

TEST(RigidBodyChecker, TurnsABodyInSpace)
{
    const auto si = std::make_shared<ob::SpaceInformation>(makeSpace<ob::SE3StateSpace>(3));
    const RigidBodyChecker checker(si, roomScene(1));
    ob::ScopedState<ob::SE3StateSpace> state(si);
    state->setXYZ(4.5, 5.0, 1.5);
    state->rotation().setIdentity();
    EXPECT_FALSE(checker.isValid(state.get()));
    state->rotation().setAxisAngle(0.0, 0.0, 1.0, kPi / 2.0);
    EXPECT_TRUE(checker.isValid(state.get()));
    EXPECT_NEAR(checker.clearance(state.get()), 0.2, 1e-6);
    state->rotation().setAxisAngle(0.0, 1.0, 0.0, kPi / 2.0);
    EXPECT_FALSE(checker.isValid(state.get())) << "as long in height as it was along x";
    state->setXYZ(4.5, 5.0, 4.5);
    EXPECT_TRUE(checker.isValid(state.get())) << "above the walls";
}

TEST(RigidBodyChecker, KeepsTheBounds)
{
    const auto si = std::make_shared<ob::SpaceInformation>(makeSpace<ob::SE2StateSpace>(2));
    const RigidBodyChecker checker(si, roomScene(1));
    ob::ScopedState<> state(si);
    place(state.get(), 19.9, 0.0, 0.0);
    EXPECT_TRUE(checker.isValid(state.get()));
    place(state.get(), 20.1, 0.0, 0.0);
    EXPECT_FALSE(checker.isValid(state.get()));
}

TEST(RigidBodyChecker, KeepsSeveralBodiesApart)
{
    auto space = std::make_shared<ob::CompoundStateSpace>();
    space->addSubspace(makeSpace<ob::SE2StateSpace>(2), 1.0);
    space->addSubspace(makeSpace<ob::SE3StateSpace>(3), 1.0);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    const RigidBodyChecker checker(si, roomScene(2));
    ob::ScopedState<> state(si);
    auto* parts = state->as<ob::CompoundState>();
    place(parts->components[0], 2.0, 2.0, 0.0);
    auto* second = parts->as<ob::SE3StateSpace::StateType>(1);
    second->rotation().setIdentity();
    second->setXYZ(2.3, 2.0, 0.9);
    EXPECT_FALSE(checker.isValid(state.get()));
    second->setXYZ(2.3, 2.0, 1.1);
    EXPECT_TRUE(checker.isValid(state.get())) << "one above the other";
    EXPECT_NEAR(checker.clearance(state.get()), 0.1, 1e-6);
    EXPECT_EQ(posesOf(*space, state.get()).size(), 2U);
}

TEST(RigidBodyChecker, RefusesSpacesThatDoNotFit)
{
    const auto vector = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2));
    vector->getStateSpace()->setName("vectors");
    const auto refusal = [](const ob::SpaceInformationPtr& si, std::size_t robots)
    { return test::complaintOf<std::invalid_argument>([&] { RigidBodyChecker(si, roomScene(robots)); }); };
    EXPECT_EQ(refusal(vector, 1), "the state space 'vectors' must be SE2, SE3 or a compound of these");
    const auto plane = std::make_shared<ob::SpaceInformation>(makeSpace<ob::SE2StateSpace>(2));
    plane->getStateSpace()->setName("plane");
    EXPECT_EQ(refusal(plane, 2), "the state space 'plane' holds 1 poses, but the scene has 2 robots");
}

/// Eight threads ask one checker the same questions in different orders; the thread sanitizer watches.
TEST(RigidBodyCheckerThreads, EightThreadsGetTheAnswersOfOne)
{
    const auto si = std::make_shared<ob::SpaceInformation>(makeSpace<ob::SE3StateSpace>(3));
    const RigidBodyChecker checker(si, roomScene(1));
    test::expectOneThreadsAnswers(si, checker, checker, 1600, 10);
}
}  // namespace
}  // namespace specplan::problems
