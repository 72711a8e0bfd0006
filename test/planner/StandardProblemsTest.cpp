// SPDX-License-Identifier: BSD-3-Clause
// Problems like those that OMPL tests its planners with, solved with default parameters and a bounded number of steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kPi = std::numbers::pi;

struct Segment
{
    double x0, y0, x1, y1;
};

/// Whether the insides of two segments cross.
bool cross(const Segment& a, const Segment& b)
{
    const double ax = a.x1 - a.x0, ay = a.y1 - a.y0;
    const double bx = b.x1 - b.x0, by = b.y1 - b.y0;
    const double determinant = ax * by - bx * ay;
    if (std::abs(determinant) < 1e-15)
        return false;
    const double dx = a.x0 - b.x0, dy = a.y0 - b.y0;
    const double s = (ax * dy - ay * dx) / determinant;
    const double t = (bx * dy - by * dx) / determinant;
    const auto inside = [](double at) { return at > 1e-6 && at < 1.0 - 1e-6; };
    return inside(s) && inside(t);
}

/// A planar arm in a bent funnel, after OMPL's kinematic chain.
class Chain
{
public:
    explicit Chain(unsigned links) : links_(links), length_(1.0 / links)
    {
        const double gap = std::log(static_cast<double>(links)) / links;
        for (const int side : {-1, 1})
        {
            double x = length_, y = side * gap, angle = 0.0;
            const double step = length_ * (1.0 - side * kPi * gap);
            for (unsigned i = 0; i + 1 < links; ++i)
            {
                angle += kPi / links;
                const Segment wall{x, y, x + std::cos(angle) * step, y + std::sin(angle) * step};
                walls_.push_back(wall);
                x = wall.x1;
                y = wall.y1;
            }
        }
    }

    [[nodiscard]] bool isValid(const std::vector<double>& joints) const
    {
        std::vector<Segment> arm;
        double angle = 0.0, x = 0.0, y = 0.0;
        for (const double joint : joints)
        {
            angle += joint;
            arm.push_back({x, y, x + std::cos(angle) * length_, y + std::sin(angle) * length_});
            x = arm.back().x1;
            y = arm.back().y1;
        }
        for (std::size_t i = 0; i < arm.size(); ++i)
        {
            for (std::size_t j = i + 1; j < arm.size(); ++j)
                if (cross(arm[i], arm[j]))
                    return false;
            for (const Segment& wall : walls_)
                if (cross(arm[i], wall))
                    return false;
        }
        return true;
    }

    [[nodiscard]] std::vector<double> start() const
    {
        std::vector<double> joints(links_, kPi / links_);
        joints.front() = 0.0;
        return joints;
    }

    [[nodiscard]] std::vector<double> goal() const
    {
        std::vector<double> joints(links_, 0.0);
        joints.front() = kPi - 0.001;
        return joints;
    }

private:
    unsigned links_;
    double length_;
    std::vector<Segment> walls_;
};

/// Measures how far the links' ends move.
class LinkSpace : public ob::RealVectorStateSpace
{
public:
    using ob::RealVectorStateSpace::RealVectorStateSpace;

    double distance(const ob::State* a, const ob::State* b) const override
    {
        const double* p = a->as<StateType>()->values;
        const double* q = b->as<StateType>()->values;
        double sum = 0.0, angleP = 0.0, angleQ = 0.0, dx = 0.0, dy = 0.0;
        for (unsigned i = 0; i < dimension_; ++i)
        {
            angleP += p[i];
            angleQ += q[i];
            dx += std::cos(angleP) - std::cos(angleQ);
            dy += std::sin(angleP) - std::sin(angleQ);
            sum += std::hypot(dx, dy);
        }
        return sum / dimension_;
    }
};

ob::StateSpacePtr makeJointSpace(const std::string& kind, unsigned links)
{
    if (kind == "Angles")
    {
        auto space = std::make_shared<ob::CompoundStateSpace>();
        for (unsigned i = 0; i < links; ++i)
            space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 1.0);
        return space;
    }
    auto space =
        kind == "Links" ? std::make_shared<LinkSpace>(links) : std::make_shared<ob::RealVectorStateSpace>(links);
    space->setBounds(-kPi, kPi);
    return space;
}

/// Solves with default parameters. \param steps expansions and checks of motions, how many at most.
void expectSolved(og::SimpleSetup& setup, unsigned steps)
{
    setup.setPlanner(std::make_shared<SpeculativeAStar>(setup.getSpaceInformation()));
    const ob::PlannerStatus status =
        setup.solve(ob::PlannerTerminationCondition([steps, taken = 0U]() mutable { return ++taken > steps; }));
    ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(setup.getSolutionPath().check());
}

class KinematicChain : public testing::TestWithParam<std::tuple<std::string, unsigned>>
{
};

TEST_P(KinematicChain, IsSolved)
{
    const auto& [kind, links] = GetParam();
    const Chain chain(links);
    const ob::StateSpacePtr space = makeJointSpace(kind, links);
    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(
        [&chain, &space](const ob::State* state)
        {
            std::vector<double> joints;
            space->copyToReals(joints, state);
            return chain.isValid(joints);
        });
    space->setup();
    ob::ScopedState<> start(space), goal(space);
    space->copyFromReals(start.get(), chain.start());
    space->copyFromReals(goal.get(), chain.goal());
    setup.setStartAndGoalStates(start, goal);
    expectSolved(setup, 200000);
}

INSTANTIATE_TEST_SUITE_P(All, KinematicChain,
                         testing::Combine(testing::Values("Links", "Angles", "RealVector"),
                                          testing::Values(5U, 6U, 7U, 8U, 9U, 10U)),
                         [](const testing::TestParamInfo<std::tuple<std::string, unsigned>>& of)
                         { return std::get<0>(of.param) + std::to_string(std::get<1>(of.param)); });

TEST(Circles, AreAllSolved)
{
    std::mt19937 random(20);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    struct Circle
    {
        double x, y, radius;
    };
    unsigned tried = 0;
    while (tried < 50)
    {
        std::vector<Circle> circles;
        for (int i = 0; i < 12; ++i)
            circles.push_back({place(random), place(random), 0.02 + 0.05 * place(random)});
        const auto isFree = [&](double x, double y)
        {
            return std::ranges::all_of(circles, [&](const Circle& circle)
                                       { return std::hypot(x - circle.x, y - circle.y) > circle.radius + 0.02; });
        };
        if (!isFree(0.02, 0.02) || !isFree(0.97, 0.95))
            continue;
        ++tried;
        auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(0.0, 1.0);
        og::SimpleSetup setup(space);
        setup.setStateValidityChecker(
            [&](const ob::State* state)
            {
                const double* at = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return std::ranges::all_of(circles, [&](const Circle& circle)
                                           { return std::hypot(at[0] - circle.x, at[1] - circle.y) > circle.radius; });
            });
        ob::ScopedState<> start(space), goal(space);
        start[0] = start[1] = 0.02;
        goal[0] = 0.97;
        goal[1] = 0.95;
        setup.setStartAndGoalStates(start, goal);
        expectSolved(setup, 20000);
    }
}
}  // namespace
}  // namespace specplan::test
