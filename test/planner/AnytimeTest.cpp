// SPDX-License-Identifier: BSD-3-Clause
// What goes on after the first solution, and what stays known after a query.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <ompl/base/ConstrainedSpaceInformation.h>
#include <ompl/base/Constraint.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/constraint/ProjectedStateSpace.h>

#include "Scene.h"

namespace specplan::test
{
namespace
{
/// Stops after so many evaluations of the condition, which is once for each expansion.
ob::PlannerTerminationCondition afterEvaluations(unsigned count)
{
    return ob::PlannerTerminationCondition([count, asked = 0U]() mutable { return ++asked > count; });
}

void askForLength(Scene& scene)
{
    scene.setup.setOptimizationObjective(
        std::make_shared<ob::PathLengthOptimizationObjective>(scene.setup.getSpaceInformation()));
}

TEST(Anytime, WeightsShrinkAndTheLatticeIsRefinedWhileThereIsTime)
{
    Scene scene;
    PlannerSettings settings = settingsFor(2, "runahead");
    settings.weight = 8.0;
    askForLength(scene);
    scene.plan(settings);
    std::vector<double> costs;
    scene.setup.getProblemDefinition()->setIntermediateSolutionCallback(
        [&](const ob::Planner*, const std::vector<const ob::State*>& states, const ob::Cost cost)
        {
            EXPECT_EQ(scene.values(states.front()), scene.start[0]);
            EXPECT_EQ(scene.values(states.back()), scene.goals[0]);
            costs.push_back(cost.value());
        });
    ASSERT_EQ(scene.solve(afterEvaluations(60000)), ob::PlannerStatus::EXACT_SOLUTION);
    ASSERT_GE(costs.size(), 3U);
    for (std::size_t i = 1; i < costs.size(); ++i)
        EXPECT_LT(costs[i], costs[i - 1]);
    const SearchReport& report = scene.planner->getReport();
    EXPECT_EQ(report.bound, 1.0);
    EXPECT_GE(report.refinements, 1U);
    EXPECT_EQ(report.cost, costs.back());
    EXPECT_NEAR(scene.path().length(), costs.back(), 1e-9);
    EXPECT_TRUE(scene.path().check());
}

TEST(Anytime, VerdictsStayFromOneLatticeToTheNext)
{
    Scene scene;
    PlannerSettings settings = settingsFor(1);
    askForLength(scene);
    scene.plan(settings);
    scene.freeze();
    scene.calls = 0;
    ASSERT_EQ(scene.solve(afterEvaluations(30000)), ob::PlannerStatus::EXACT_SOLUTION);
    const SearchReport& report = scene.planner->getReport();
    ASSERT_GE(report.refinements, 1U);
    // Each check ran once; a motion of a fine lattice has no states inside.
    // Start and goal were checked before.
    EXPECT_EQ(report.checksTotal - 2, report.checksUsed - report.usedReady);
    EXPECT_EQ(scene.callsOutside, 0);
}

TEST(Anytime, StopsWhereTheObjectiveIsSatisfiedOrNobodyAskedForMore)
{
    Scene plain;
    plain.plan(settingsFor(1));
    ASSERT_EQ(plain.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(plain.planner->getReport().refinements, 0U);

    Scene satisfied;
    askForLength(satisfied);
    satisfied.setup.getOptimizationObjective()->setCostThreshold(ob::Cost(100.0));
    satisfied.plan(settingsFor(1));
    ASSERT_EQ(satisfied.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(satisfied.planner->getReport().refinements, 0U);

    Scene off;
    askForLength(off);
    PlannerSettings settings = settingsFor(1);
    settings.anytime = false;
    off.plan(settings);
    ASSERT_EQ(off.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST(Anytime, APassageNarrowerThanTheFirstLatticeIsFoundOnAFinerOne)
{
    // A slit between two lines of the first lattice, and a validity resolution that sees it.
    Scene scene;
    scene.setup.getStateSpace()->setLongestValidSegmentFraction(0.001);
    scene.setup.setStateValidityChecker(
        [&](const ob::State* state)
        {
            const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return std::abs(x[0] - 0.5) > 0.05 || std::abs(x[1] - 0.3055) < 0.002;
        });
    scene.plan(settingsFor(2, "runahead"));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GE(scene.planner->getReport().refinements, 1U);
    EXPECT_TRUE(scene.path().check());

    PlannerSettings once = settingsFor(2, "runahead");
    once.anytime = false;
    scene.plan(once);
    EXPECT_NE(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST(Anytime, TheFirstPathMayBeAllThatIsWanted)
{
    Scene scene;
    askForLength(scene);
    scene.setup.getStateSpace()->setLongestValidSegmentFraction(0.001);
    scene.setup.setStateValidityChecker(
        [&](const ob::State* state)
        {
            const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return std::abs(x[0] - 0.5) > 0.05 || std::abs(x[1] - 0.3055) < 0.002;
        });
    PlannerSettings first = settingsFor(1);
    first.stopAtFirstPath = true;
    first.weight = 3.0;
    scene.plan(first);
    ASSERT_EQ(scene.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION)
        << "goes on to finer lattices before the first path";
    const SearchReport& report = scene.planner->getReport();
    EXPECT_GE(report.refinements, 1U);
    EXPECT_EQ(report.weight, 3.0) << "no search with a smaller weight was begun";
    EXPECT_EQ(report.bound, 3.0);
}

/// The first path of a problem that asks for short ones, as the best costs that the planner tells of.
std::vector<double> costsOf(Scene& scene, const PlannerSettings& settings, unsigned evaluations)
{
    askForLength(scene);
    scene.plan(settings);
    std::vector<double> costs;
    scene.setup.getProblemDefinition()->setIntermediateSolutionCallback(
        [&](const ob::Planner*, const std::vector<const ob::State*>&, const ob::Cost cost)
        { costs.push_back(cost.value()); });
    EXPECT_EQ(scene.solve(afterEvaluations(evaluations)), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(scene.path().check());
    return costs;
}

TEST(Anytime, WithFewAxesTheFirstPathComesFromACoarserLattice)
{
    // A wall close to the goal, so that a search through the whole space comes first.
    const auto wall = [](Scene& scene)
    {
        scene.setup.setStateValidityChecker(
            [](const ob::State* state)
            {
                const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return std::abs(x[0] - 0.8) > 0.05 || x[1] < 0.15;
            });
    };
    Scene usual(3);
    wall(usual);
    PlannerSettings settings = settingsFor(1);
    settings.weight = 10.0;
    settings.stopAtFirstPath = true;
    (void)costsOf(usual, settings, 1000000);
    const std::uint64_t checksOfUsual = usual.planner->getReport().checksUsed;

    PlannerSettings hasty = settingsFor(1);
    Scene first(3);
    wall(first);
    askForLength(first);
    first.setup.getOptimizationObjective()->setCostThreshold(ob::Cost(100.0));
    first.plan(hasty);
    ASSERT_EQ(first.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(first.path().check());
    EXPECT_LT(first.planner->getReport().checksUsed * 4, checksOfUsual);
    EXPECT_TRUE(std::isnan(first.planner->getReport().bound)) << "nothing is known of the usual lattice yet";
    EXPECT_EQ(first.planner->getReport().refinements, 0U);

    // What follows is the usual lattice with weights down to 1, as without the coarse one.
    Scene both(3);
    wall(both);
    const std::vector<double> costs = costsOf(both, hasty, 400000);
    EXPECT_EQ(both.planner->getReport().bound, 1.0);
    EXPECT_LT(costs.back(), first.planner->getReport().cost);
    Scene optimal(3);
    wall(optimal);
    PlannerSettings exact = settingsFor(1);
    exact.weight = 1.0;
    exact.stopAtFirstPath = true;
    const double optimum = costsOf(optimal, exact, 1000000).back();
    EXPECT_TRUE(std::ranges::any_of(costs, [&](double cost) { return std::abs(cost - optimum) < 1e-9; }))
        << "the usual lattice is the one without the coarse one";
}

TEST(Anytime, AngleAloneHasTheSameLatticeWhetherACoarserOneComesFirstOrNot)
{
    for (const bool anytime : {false, true})
    {
        auto space = std::make_shared<ob::SO2StateSpace>();
        og::SimpleSetup setup(space);
        setup.setStateValidityChecker([](const ob::State*) { return true; });
        ob::ScopedState<ob::SO2StateSpace> start(space);
        ob::ScopedState<ob::SO2StateSpace> goal(space);
        start->value = 0.1;
        goal->value = 2.0;
        setup.setStartAndGoalStates(start, goal);
        setup.setOptimizationObjective(
            std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation()));
        setup.getOptimizationObjective()->setCostThreshold(ob::Cost(100.0));
        PlannerSettings settings = settingsFor(1);
        settings.anytime = anytime;
        auto planner = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settings);
        setup.setPlanner(planner);
        setup.setup();
        std::ostringstream out;
        planner->explain(out);
        EXPECT_NE(out.str().find(anytime ? "50 values" : "100 values"), std::string::npos) << out.str();
        EXPECT_EQ(out.str().find("for a first path") != std::string::npos, anytime) << out.str();
    }
}

/// Five axes and a wall between start and goal, with its gap far off: a long way to search on the usual lattice.
struct ManyAxes : Scene
{
    ManyAxes() : Scene(5)
    {
        goals = {{0.9, 0.1, 0.1, 0.1, 0.1}};
        askForLength(*this);
        setup.getOptimizationObjective()->setCostThreshold(ob::Cost(100.0));  // the first path will do
    }
};

TEST(Anytime, WithManyAxesTheFirstPathMayComeFromACoarserLattice)
{
    ManyAxes usual;
    PlannerSettings settings = settingsFor(1);
    settings.weight = 10.0;
    settings.stopAtFirstPath = true;
    usual.plan(settings);
    ASSERT_EQ(usual.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const std::uint64_t checksOfUsual = usual.planner->getReport().checksUsed;
    ASSERT_GT(checksOfUsual, 4000U);

    settings.stopAtFirstPath = false;
    std::uint64_t orderHash = 0;
    for (const unsigned threads : {1U, 2U, 4U})
    {
        ManyAxes scene;
        settings.numThreads = threads;
        settings.speculationPolicy = "runahead";
        scene.plan(settings);
        ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        const SearchReport& report = scene.planner->getReport();
        EXPECT_TRUE(scene.path().check());
        EXPECT_LT(report.checksUsed * 2, checksOfUsual);
        EXPECT_GT(report.checksUsed, 4000U);
        EXPECT_EQ(report.refinements, 0U);
        if (threads == 1)
            orderHash = report.orderHash;
        EXPECT_EQ(report.orderHash, orderHash);
    }
}

TEST(Anytime, WhereTheCoarserLatticeHasNoPathTheUsualOneHas)
{
    // A slit that the usual lattice, through 0.1 with 12 steps, has nodes in: at 0.1 + 9 / 12, not at 0.1 + 10 / 12.
    ManyAxes scene;
    scene.setup.setStateValidityChecker(
        [](const ob::State* state)
        {
            const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return std::abs(x[0] - 0.5) > 0.05 || std::abs(x[1] - 0.85) < 0.03;
        });
    PlannerSettings settings = settingsFor(1);
    settings.weight = 10.0;
    scene.plan(settings);
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(scene.path().check());
    EXPECT_GT(scene.planner->getReport().checksUsed, 4000U);
    EXPECT_EQ(scene.planner->getReport().refinements, 0U);
}

TEST(Anytime, ASearchThatIsStoppedOnTheCoarserLatticeGoesOnThere)
{
    PlannerSettings settings = settingsFor(1);
    settings.weight = 10.0;
    ManyAxes whole;
    whole.plan(settings);
    ASSERT_EQ(whole.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    ManyAxes parts;
    parts.plan(settings);
    int rounds = 0;
    while (parts.solve(afterEvaluations(100)) != ob::PlannerStatus::EXACT_SOLUTION)
        ASSERT_LT(++rounds, 10000);
    EXPECT_GT(rounds, 3);
    EXPECT_EQ(parts.planner->getReport().orderHash, whole.planner->getReport().orderHash);
    EXPECT_EQ(parts.planner->getReport().checksUsed, whole.planner->getReport().checksUsed);

    // Another query begins with the usual lattice again.
    parts.setup.getProblemDefinition()->clearSolutionPaths();
    parts.planner->clearQuery();
    ASSERT_EQ(parts.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(parts.planner->getReport().orderHash, whole.planner->getReport().orderHash);
    EXPECT_EQ(parts.planner->getReport().checksTotal, 2U) << "all but start and goal is known";
}

class Queries : public testing::TestWithParam<unsigned>
{
};

INSTANTIATE_TEST_SUITE_P(Threads, Queries, testing::Values(1U, 4U));

TEST_P(Queries, TheSecondOnePaysForWhatIsNewOnly)
{
    Scene scene;
    PlannerSettings settings = settingsFor(GetParam(), "none");
    settings.resolution = 0.02;
    settings.weight = 1.0;
    scene.plan(settings);
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const SearchReport first = scene.planner->getReport();
    EXPECT_EQ(first.checksReused, 0U);

    scene.planner->clearQuery();
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const SearchReport same = scene.planner->getReport();
    EXPECT_EQ(same.checksTotal, 2U) << "start and goal";
    EXPECT_EQ(same.orderHash, first.orderHash);
    EXPECT_EQ(same.cost, first.cost);
    EXPECT_GT(same.checksReused, 0U);

    // Another start on the same lattice: the answer of a planner that starts from nothing, for fewer checks.
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    scene.setup.clearStartStates();
    scene.setup.addStartState(scene.state({0.2, 0.1}));
    scene.planner->clearQuery();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const SearchReport moved = scene.planner->getReport();
    EXPECT_GT(moved.checksReused, 1000U);
    EXPECT_TRUE(scene.path().check());
    scene.planner->clear();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_LT(moved.checksTotal + 1000, scene.planner->getReport().checksTotal);
}

TEST_P(Queries, ClearAForgetCallAndANewCheckerForgetVerdicts)
{
    Scene scene;
    scene.plan(settingsFor(GetParam()));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const auto again = [&]
    {
        scene.setup.getProblemDefinition()->clearSolutionPaths();
        EXPECT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_GT(scene.planner->getReport().checksTotal, 0U);
        EXPECT_EQ(scene.planner->getReport().checksReused, 0U);
    };
    scene.planner->clear();
    again();
    scene.planner->forgetVerdicts();
    again();
    scene.planner->clearQuery();
    scene.setup.setStateValidityChecker([&scene](const ob::State* state) { return scene.isValid(state); });
    again();
}

TEST(Explain, TellsTheLatticeWithoutSearchingIt)
{
    Scene scene;
    scene.plan(settingsFor(2));
    scene.calls = 0;
    std::ostringstream out;
    scene.planner->explain(out);
    EXPECT_LE(scene.calls, 4);
    EXPECT_NE(out.str().find("axis 0: 0 to 1, 101 values, spacing 0.00990099"), std::string::npos) << out.str();
    EXPECT_NE(out.str().find("8 motions"), std::string::npos) << out.str();
    EXPECT_NE(out.str().find("Goals: 1 states"), std::string::npos) << out.str();
    // Nothing is lost: the search goes on from here.
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST(Explain, TellsCornersFromInsides)
{
    Scene scene;
    PlannerSettings settings = settingsFor(1);
    settings.cornerCutting = false;
    settings.spacing = {0.005};
    scene.plan(settings);
    std::ostringstream out;
    scene.planner->explain(out);
    EXPECT_NE(out.str().find(", 0 of them checked inside, 4 past corners"), std::string::npos) << out.str();
}

TEST(Explain, PlacesOfBodiesAreEquallyFarApartAlongAllAxes)
{
    const auto explained = [](const std::vector<double>& extents)
    {
        auto space = std::make_shared<ob::SE3StateSpace>();
        ob::RealVectorBounds bounds(3);
        for (unsigned axis = 0; axis < 3; ++axis)
            bounds.setHigh(axis, extents[axis]);
        space->setBounds(bounds);
        og::SimpleSetup setup(space);
        setup.setStateValidityChecker([](const ob::State*) { return true; });
        ob::ScopedState<ob::SE3StateSpace> start(space);
        start->setXYZ(0.0, 0.0, 0.0);
        start->rotation().setIdentity();
        setup.setStartAndGoalStates(start, start);
        auto planner = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settingsFor(1));
        setup.setPlanner(planner);
        setup.setup();
        std::ostringstream out;
        planner->explain(out);
        return out.str();
    };
    const auto hasAxis = [](const std::string& text, int axis, const std::string& values)
    { return text.find("axis " + std::to_string(axis) + ": 0 to " + values) != std::string::npos; };
    // 20 x 20 x 20 cells of the same size.
    const std::string room = explained({40.0, 20.0, 10.0});
    EXPECT_TRUE(hasAxis(room, 0, "40, 41 values, spacing 1\n") && hasAxis(room, 1, "20, 21 values, spacing 1\n") &&
                hasAxis(room, 2, "10, 11 values, spacing 1\n"))
        << room;
    // A thin one keeps four cells, and the others share the rest: 2000 cells of the same size.
    const std::string thin = explained({50.0, 40.0, 0.1});
    EXPECT_TRUE(hasAxis(thin, 0, "50, 51 values, spacing 1\n") && hasAxis(thin, 1, "40, 41 values, spacing 1\n") &&
                hasAxis(thin, 2, "0.1, 5 values, spacing 0.025\n"))
        << thin;
}

TEST(Explain, SpacingTakesAValueForEachAxisAndRotation)
{
    auto space = std::make_shared<ob::SE3StateSpace>();
    ob::RealVectorBounds bounds(3);
    bounds.setHigh(10.0);
    space->setBounds(bounds);
    og::SimpleSetup setup(space);
    setup.setStateValidityChecker([](const ob::State*) { return true; });
    ob::ScopedState<ob::SE3StateSpace> start(space);
    start->setXYZ(5.0, 5.0, 5.0);
    start->rotation().setIdentity();
    setup.setStartAndGoalStates(start, start);
    auto planner = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settingsFor(1));
    setup.setPlanner(planner);
    setup.setup();
    const auto explained = [&planner](const std::vector<double>& spacing)
    {
        PlannerSettings settings = settingsFor(1);
        settings.spacing = spacing;
        planner->setSettings(settings);
        std::ostringstream out;
        planner->explain(out);
        return out.str();
    };
    const auto has = [](const std::string& text, const std::string& part)
    { return text.find(part) != std::string::npos; };
    const std::string all = explained({1.0, 2.0, 5.0, std::numbers::pi / 4.0});
    EXPECT_TRUE(has(all, "11 values, spacing 1\n") && has(all, "5 values, spacing 2\n") &&
                has(all, "3 values, spacing 5\n") && has(all, "all rotations, 272 of them"))
        << all;
    const std::string places = explained({1.0, 2.0, 5.0});
    EXPECT_TRUE(has(places, "3 values, spacing 5\n") && has(places, "all rotations, 40 of them")) << places;
    try
    {
        (void)explained({1.0, 2.0});
        FAIL() << "two values are refused";
    }
    catch (const ompl::Exception& error)
    {
        EXPECT_TRUE(has(error.what(), "spacing has 2 values; give one, or 3 for the axes, or 4 for: ")) << error.what();
        EXPECT_TRUE(has(error.what(), "(rotation)")) << error.what();
    }
}

/// The unit sphere.
class Sphere : public ob::Constraint
{
public:
    Sphere() : ob::Constraint(3, 1)
    {
    }

    void function(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> out) const override
    {
        out[0] = x.norm() - 1.0;
    }
};

TEST(Spaces, ConstrainedOnesAreRefusedWithTheReason)
{
    auto ambient = std::make_shared<ob::RealVectorStateSpace>(3);
    ambient->setBounds(-2.0, 2.0);
    auto space = std::make_shared<ob::ProjectedStateSpace>(ambient, std::make_shared<Sphere>());
    auto si = std::make_shared<ob::ConstrainedSpaceInformation>(space);
    si->setStateValidityChecker([](const ob::State*) { return true; });
    si->setup();
    ob::ScopedState<> pole(space);
    pole->as<ob::ConstrainedStateSpace::StateType>()->copy(Eigen::Vector3d(0.0, 0.0, 1.0));
    auto pdef = std::make_shared<ob::ProblemDefinition>(si);
    pdef->setStartAndGoalStates(pole, pole);
    SpeculativeAStar planner(si);
    planner.setProblemDefinition(pdef);
    EXPECT_THROW(planner.checkValidity(), ompl::Exception);
    EXPECT_EQ(planner.solve(0.1), ob::PlannerStatus::CRASH);
    const std::string& error = planner.getReport().error;
    EXPECT_NE(error.find("constrained to a manifold"), std::string::npos) << error;
}

TEST(Heuristics, AUsersCostToGoCountsAndMayBeInconsistent)
{
    std::vector<double> costs;
    std::vector<std::uint64_t> expansions;
    for (const bool users : {false, true})
    {
        Scene scene;
        askForLength(scene);
        const auto goal = scene.state(scene.goals[0]);
        if (users)  // knows that the gap is at the top; jumps where the wall begins
            scene.setup.getOptimizationObjective()->setCostToGoHeuristic(
                [&, goal](const ob::State* state, const ob::Goal*)
                {
                    const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    const bool before = x[0] < 0.45 && x[1] < 0.8;
                    return ob::Cost(before ? std::hypot(0.55 - x[0], 0.8 - x[1]) + 0.35
                                           : scene.space->distance(state, goal.get()));
                });
        PlannerSettings settings = settingsFor(2, "runahead");
        settings.anytime = false;
        scene.plan(settings);
        ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        costs.push_back(scene.planner->getReport().cost);
        expansions.push_back(scene.planner->getReport().expansions);
    }
    EXPECT_NEAR(costs[1], costs[0], 1e-9);
    EXPECT_LT(expansions[1], expansions[0]);
}
}  // namespace
}  // namespace specplan::test
