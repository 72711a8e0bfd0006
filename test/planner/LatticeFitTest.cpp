// SPDX-License-Identifier: BSD-3-Clause
// Spaces over which a lattice of their values does not fit, as OMPL has some from version 1.6 on; these are like them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>

#include "Scene.h"

#if __has_include(<ompl/base/spaces/special/KleinBottleStateSpace.h>)
#include <ompl/base/spaces/special/KleinBottleStateSpace.h>
#else
namespace ompl::base
{
/// A cylinder whose ends are glued together the other way round; older versions do not have it.
class KleinBottleStateSpace : public CompoundStateSpace
{
public:
    KleinBottleStateSpace()
    {
        auto along = std::make_shared<RealVectorStateSpace>(1);
        along->setBounds(0.0, std::numbers::pi);
        addSubspace(along, 1.0);
        addSubspace(std::make_shared<SO2StateSpace>(), 1.0);
        lock();
    }
};
}  // namespace ompl::base
#endif

namespace specplan::test
{
namespace
{
/// Like an aircraft that circles once on every motion.
class Circling : public ob::SE2StateSpace
{
public:
    Circling()
    {
        setName("circling");
        ob::RealVectorBounds bounds(2);
        bounds.setLow(-10.0);
        bounds.setHigh(10.0);
        setBounds(bounds);
    }

    double distance(const ob::State* a, const ob::State* b) const override
    {
        return ob::SE2StateSpace::distance(a, b) + 2.0 * std::numbers::pi;
    }

    void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override
    {
        ob::SE2StateSpace::interpolate(from, to, t, state);
        auto* at = state->as<StateType>();
        at->setX(at->getX() + std::cos(2.0 * std::numbers::pi * t) - 1.0);
        at->setY(at->getY() + std::sin(2.0 * std::numbers::pi * t));
    }
};

/// A place and a time, tied by a greatest speed of 1.
class SpaceTime : public ob::CompoundStateSpace
{
public:
    SpaceTime()
    {
        setName("space and time");
        auto place = std::make_shared<ob::RealVectorStateSpace>(2);
        place->setName("place");
        place->setBounds(-10.0, 10.0);
        addSubspace(place, 0.5);
        auto time = std::make_shared<ob::TimeStateSpace>();
        time->setBounds(0.0, 60.0);
        addSubspace(time, 0.5);
        lock();
    }

    double distance(const ob::State* a, const ob::State* b) const override
    {
        const double way = components_[0]->distance(a->as<ob::CompoundState>()->components[0],
                                                    b->as<ob::CompoundState>()->components[0]);
        const double time = components_[1]->distance(a->as<ob::CompoundState>()->components[1],
                                                     b->as<ob::CompoundState>()->components[1]);
        return way > time + 1e-6 ? std::numeric_limits<double>::infinity() : 0.5 * way + 0.5 * time;
    }
};

/// Measures in a way of its own, but moves straight.
class Hasty : public ob::SE2StateSpace
{
public:
    Hasty()
    {
        ob::RealVectorBounds bounds(2);
        bounds.setLow(-1.0);
        bounds.setHigh(1.0);
        setBounds(bounds);
    }

    double distance(const ob::State* a, const ob::State* b) const override
    {
        return std::sqrt(ob::SE2StateSpace::distance(a, b));
    }
};

struct Answer
{
    ob::PlannerStatus status;
    std::string error;
    int checks;
};

Answer solve(const ob::StateSpacePtr& space, const std::vector<double>& from, const std::vector<double>& to)
{
    og::SimpleSetup setup(space);
    int checks = 0;
    setup.setStateValidityChecker(
        [&checks](const ob::State*)
        {
            ++checks;
            return true;
        });
    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    space->setup();
    space->copyFromReals(start.get(), from);
    space->copyFromReals(goal.get(), to);
    setup.setStartAndGoalStates(start, goal);
    const auto planner = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settingsFor(1));
    setup.setPlanner(planner);
    setup.setup();
    checks = 0;
    const ob::PlannerStatus status = setup.solve(20.0);
    return {status, planner->getReport().error, checks};
}

void expectRefused(const Answer& answer, const std::string& space, const std::string& reason)
{
    EXPECT_EQ(answer.status, ob::PlannerStatus::CRASH);
    EXPECT_NE(answer.error.find(space), std::string::npos) << answer.error;
    EXPECT_NE(answer.error.find(reason), std::string::npos) << answer.error;
    EXPECT_LE(answer.checks, 1) << "refused before anything but the start is checked";
}

TEST(LatticeFit, CurvesAreRefused)
{
    expectRefused(solve(std::make_shared<Circling>(), {-8.0, -8.0, 0.0}, {8.0, 7.0, 1.0}),
                  "there is no lattice over the state space 'circling'", "curves");
}

TEST(LatticeFit, TimeAndPlaceTiedByAGreatestSpeedAreRefused)
{
    expectRefused(solve(std::make_shared<SpaceTime>(), {-8.0, -8.0, 0.0}, {8.0, 7.0, 40.0}), "space and time",
                  "'place' alone is infinitely long");
}

TEST(LatticeFit, KleinsBottleIsRefused)
{
    expectRefused(solve(std::make_shared<ob::KleinBottleStateSpace>(), {0.1, 0.1}, {3.0, 2.0}), "", "glued together");
}

TEST(LatticeFit, AMetricOfOnesOwnIsNot)
{
    const Answer answer = solve(std::make_shared<Hasty>(), {-0.8, -0.8, 0.0}, {0.8, 0.7, 1.0});
    EXPECT_EQ(answer.status, ob::PlannerStatus::EXACT_SOLUTION) << answer.error;
}
}  // namespace
}  // namespace specplan::test
