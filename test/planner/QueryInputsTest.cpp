// SPDX-License-Identifier: BSD-3-Clause
// Starts and goals that are replaced, come late, cannot come, or are no numbers.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <sstream>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Exception.h>

#include "Scene.h"
#include "specplan/planner/OmplCompat.h"

namespace specplan::test
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Stops never, so that a wait that has no end fails by the test's own time limit.
ob::PlannerStatus solveForEver(Scene& scene)
{
    return scene.solve(ob::plannerNonTerminatingCondition());
}

TEST(QueryInputs, AnotherProblemDefinitionIsAnotherQuery)
{
    Scene scene;
    scene.plan(settingsFor(2));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    auto other = std::make_shared<ob::ProblemDefinition>(scene.setup.getSpaceInformation());
    other->setStartAndGoalStates(scene.state({0.2, 0.9}), scene.state({0.8, 0.2}));
    scene.planner->setProblemDefinition(other);
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    auto& path = *other->getSolutionPath()->as<og::PathGeometric>();
    EXPECT_EQ(scene.values(path.getStates().front()), (std::vector<double>{0.2, 0.9}));
    EXPECT_EQ(scene.values(path.getStates().back()), (std::vector<double>{0.8, 0.2}));
    EXPECT_GT(scene.planner->getReport().checksReused, 0U) << "what was known of the scene was checked anew";
}

TEST(QueryInputs, AGoalReplacedInTheSameDefinitionIsAnotherQuery)
{
    Scene scene;
    scene.plan(settingsFor(2));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    scene.setup.getProblemDefinition()->setGoalState(scene.state({0.2, 0.9}));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.values(scene.path().getStates().back()), (std::vector<double>{0.2, 0.9}));
}

TEST(QueryInputs, StatesChangedInPlaceAreAnotherQuery)
{
    Scene scene;
    scene.plan(settingsFor(1));
    auto goal = std::make_shared<ob::GoalState>(scene.setup.getSpaceInformation());
    goal->setState(scene.state({0.9, 0.9}));
    scene.setup.setGoal(goal);
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    goal->setState(scene.state({0.3, 0.2}));
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.values(scene.path().getStates().back()), (std::vector<double>{0.3, 0.2}));

    scene.setup.getProblemDefinition()->clearSolutionPaths();
    scene.setup.getProblemDefinition()->clearStartStates();
    scene.setup.getProblemDefinition()->addStartState(scene.state({0.1, 0.7}));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.values(scene.path().getStates().front()), (std::vector<double>{0.1, 0.7}));
}

/// A region whose middle can be moved.
class Disc : public ob::GoalRegion
{
public:
    explicit Disc(const ob::SpaceInformationPtr& si) : ob::GoalRegion(si)
    {
        setThreshold(0.05);
    }

    double distanceGoal(const ob::State* state) const override
    {
        const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
        return std::hypot(x[0] - middle[0], x[1] - middle[1]);
    }

    std::array<double, 2> middle{0.9, 0.9};
};

TEST(QueryInputs, ARegionThatMovedAwayFromThePathIsAnotherQuery)
{
    Scene scene;
    scene.plan(settingsFor(1));
    const auto disc = std::make_shared<Disc>(scene.setup.getSpaceInformation());
    scene.setup.setGoal(disc);
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    disc->middle = {0.2, 0.4};
    scene.setup.getProblemDefinition()->clearSolutionPaths();
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(disc->isSatisfied(scene.path().getStates().back()));
}

TEST(QueryInputs, MoreStartsAndGoalsAreTheSameQuery)
{
    Scene scene;
    scene.closed = true;
    scene.plan(settingsFor(1));
    ASSERT_EQ(scene.solve(), planner::kInfeasible);
    const std::uint64_t expansions = scene.planner->getReport().expansions;
    scene.setup.getGoal()->as<ob::GoalStates>()->addState(scene.state({0.3, 0.4}));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.values(scene.path().getStates().back()), (std::vector<double>{0.3, 0.4}));
    EXPECT_GT(expansions, 0U);
}

TEST(QueryInputs, ValuesThatAreNoNumbersAreRefused)
{
    Scene start;
    start.start = {{kNan, 0.1}};
    start.plan(settingsFor(1));
    EXPECT_EQ(solveForEver(start), ob::PlannerStatus::INVALID_START);
    EXPECT_EQ(start.planner->getReport().error, "");

    Scene goal;
    goal.goals = {{0.9, kNan}};
    goal.plan(settingsFor(2));
    EXPECT_EQ(solveForEver(goal), ob::PlannerStatus::INVALID_GOAL);
    EXPECT_EQ(goal.planner->getReport().expansions, 0U);

    Scene one;
    one.goals = {{0.9, kNan}, {0.9, 0.9}};
    one.plan(settingsFor(2));
    EXPECT_EQ(solveForEver(one), ob::PlannerStatus::EXACT_SOLUTION);
}

/// A space of one's own that loses its way.
class Lost : public ob::RealVectorStateSpace
{
public:
    Lost() : ob::RealVectorStateSpace(2)
    {
        setBounds(0.0, 1.0);
    }

    double distance(const ob::State* a, const ob::State* b) const override
    {
        const double* from = a->as<StateType>()->values;
        return from[0] > 0.3 ? kNan : ob::RealVectorStateSpace::distance(a, b);
    }
};

TEST(QueryInputs, ADistanceThatIsNoNumberIsNamed)
{
    for (const unsigned threads : {1U, 4U})
        for (const std::string evaluation : {"eager", "lazy"})
        {
            og::SimpleSetup setup(std::make_shared<Lost>());
            setup.setStateValidityChecker([](const ob::State*) { return true; });
            ob::ScopedState<> start(setup.getStateSpace());
            ob::ScopedState<> goal(setup.getStateSpace());
            start[0] = start[1] = 0.1;
            goal[0] = goal[1] = 0.9;
            setup.setStartAndGoalStates(start, goal);
            PlannerSettings settings = settingsFor(threads);
            settings.evaluation = evaluation;
            const auto made = std::make_shared<specplan::SpeculativeAStar>(setup.getSpaceInformation(), settings);
            setup.setPlanner(made);
            EXPECT_EQ(setup.solve(20.0), ob::PlannerStatus::CRASH);
            EXPECT_NE(made->getReport().error.find("distance"), std::string::npos) << made->getReport().error;
            EXPECT_NE(made->getReport().error.find("NaN"), std::string::npos) << made->getReport().error;
        }
}

TEST(QueryInputs, GoalsThatCannotComeUpAnyMoreEndTheSearchAtOnce)
{
    Scene one;
    one.goals = {{0.5, 0.5}};
    one.plan(settingsFor(2));
    EXPECT_EQ(solveForEver(one), ob::PlannerStatus::INVALID_GOAL);

    Scene many;
    many.goals.assign(1000, {0.5, 0.5});
    many.plan(settingsFor(2));
    EXPECT_EQ(solveForEver(many), ob::PlannerStatus::INVALID_GOAL);
    EXPECT_EQ(many.planner->getReport().checksTotal, 0U) << "nothing was searched, so there is no report of checks";

    Scene none;
    none.plan(settingsFor(1));
    none.setup.setGoal(std::make_shared<ob::GoalStates>(none.setup.getSpaceInformation()));
    EXPECT_EQ(solveForEver(none), ob::PlannerStatus::INVALID_GOAL);
}

/// Like the union of goals that MoveIt makes of several goal constraints: not GoalStates, and its samples come later.
class LateUnion : public ob::GoalSampleableRegion
{
public:
    LateUnion(const ob::SpaceInformationPtr& si, std::vector<ob::ScopedState<>> states)
        : ob::GoalSampleableRegion(si), states_(std::move(states))
    {
        setThreshold(1e-6);
    }

    void sampleGoal(ob::State* state) const override
    {
        si_->copyState(state, states_.at(next_++ % available).get());
    }

    unsigned maxSampleCount() const override
    {
        return available;
    }

    bool couldSample() const override
    {
        ++asked;
        if (asked > asksBeforeNext && available < states_.size())
        {
            ++available;
            asked = 0;
        }
        return true;
    }

    double distanceGoal(const ob::State* state) const override
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& goal : states_)
            nearest = std::min(nearest, si_->distance(state, goal.get()));
        return nearest;
    }

    mutable unsigned available = 0;
    mutable unsigned asked = 0;
    unsigned asksBeforeNext = 5;

private:
    std::vector<ob::ScopedState<>> states_;
    mutable std::size_t next_ = 0;
};

TEST(QueryInputs, SamplesOfARegionMayComeLate)
{
    for (const unsigned threads : {1U, 4U})
        for (const std::string evaluation : {"eager", "lazy"})
        {
            Scene scene;
            PlannerSettings settings = settingsFor(threads);
            settings.evaluation = evaluation;
            scene.plan(settings);
            std::vector<ob::ScopedState<>> states{scene.state({0.9, 0.87})};
            const auto goal = std::make_shared<LateUnion>(scene.setup.getSpaceInformation(), std::move(states));
            scene.setup.setGoal(goal);
            ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(goal->isSatisfied(scene.path().getStates().back()));
        }
}

TEST(QueryInputs, FurtherSamplesAreWaitedForWhenNothingIsLeftToSearch)
{
    for (const unsigned threads : {1U, 4U})
        for (const std::string evaluation : {"eager", "lazy"})
        {
            Scene scene;
            scene.closed = true;
            PlannerSettings settings = settingsFor(threads);
            settings.evaluation = evaluation;
            scene.plan(settings);
            std::vector<ob::ScopedState<>> states{scene.state({0.9, 0.87}), scene.state({0.8, 0.4}),
                                                  scene.state({0.331, 0.417})};
            const auto goal = std::make_shared<LateUnion>(scene.setup.getSpaceInformation(), std::move(states));
            goal->asksBeforeNext = 20;
            scene.setup.setGoal(goal);
            ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION) << threads << evaluation;
            EXPECT_EQ(scene.values(scene.path().getStates().back()), (std::vector<double>{0.331, 0.417}));
            EXPECT_TRUE(scene.path().check());
        }
}

TEST(QueryInputs, AWaitForSamplesEndsWithTheCondition)
{
    Scene scene;
    scene.plan(settingsFor(2));
    const auto goal = std::make_shared<LateUnion>(scene.setup.getSpaceInformation(), std::vector<ob::ScopedState<>>{});
    scene.setup.setGoal(goal);
    EXPECT_NE(scene.solve(0.1), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GT(goal->asked, 1U);
}

TEST(QueryInputs, AnUnreachableRegionIsInfeasibleAfterManySamples)
{
    /// Samples for ever, and all samples lie behind the wall.
    class Endless : public ob::GoalSampleableRegion
    {
    public:
        using ob::GoalSampleableRegion::GoalSampleableRegion;

        void sampleGoal(ob::State* state) const override
        {
            double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
            x[0] = 0.8;
            x[1] = 0.1 + 1e-4 * ++samples;
        }

        unsigned maxSampleCount() const override
        {
            return std::numeric_limits<unsigned>::max();
        }

        double distanceGoal(const ob::State* state) const override
        {
            return std::abs(state->as<ob::RealVectorStateSpace::StateType>()->values[0] - 0.8);
        }

        mutable int samples = 0;
    };
    Scene scene;
    scene.closed = true;
    scene.plan(settingsFor(1));
    const auto goal = std::make_shared<Endless>(scene.setup.getSpaceInformation());
    scene.setup.setGoal(goal);
    EXPECT_EQ(solveForEver(scene), planner::kInfeasible);
    EXPECT_GT(goal->samples, 16);
}

TEST(QueryInputs, NoCheckIsBegunOnceTheConditionIsTrue)
{
    Scene starts;
    starts.start.assign(50, {0.5, 0.5});
    starts.plan(settingsFor(1));
    starts.calls = 0;
    EXPECT_EQ(starts.solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
    EXPECT_LE(starts.calls, 1);

    Scene goals;
    goals.goals.assign(50, {0.5, 0.5});
    goals.plan(settingsFor(1));
    goals.calls = 0;
    EXPECT_EQ(goals.solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
    EXPECT_LE(goals.calls, 1);
    EXPECT_EQ(goals.solve(), ob::PlannerStatus::INVALID_GOAL);
}

TEST(QueryInputs, AGoalThatCouldNotBeTakenInTimeIsTakenByTheNextCall)
{
    for (const unsigned threads : {1U, 4U})
    {
        Scene scene;
        scene.plan(settingsFor(threads));
        auto goal = std::make_shared<ob::GoalState>(scene.setup.getSpaceInformation());
        goal->setState(scene.state({0.9, 0.9}));
        goal->setThreshold(0.01);  // a region: searched for even before the state is known
        scene.setup.setGoal(goal);
        EXPECT_NE(scene.solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
        int asked = 0;
        EXPECT_NE(scene.solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 3; })),
                  ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(goal->isSatisfied(scene.path().getStates().back()));
    }
}

TEST(QueryInputs, ExplainSaysWhatItMisses)
{
    Scene scene;
    SpeculativeAStar planner(scene.setup.getSpaceInformation());
    std::ostringstream out;
    try
    {
        planner.explain(out);
        FAIL() << out.str();
    }
    catch (const ompl::Exception& error)
    {
        EXPECT_STREQ(error.what(),
                     "SpeculativeAStar: explain() needs start and goal: call it after "
                     "setProblemDefinition(), or after SimpleSetup::setup()");
    }
}

TEST(QueryInputs, TheReportIsThatOfTheLastRun)
{
    for (const bool rethrow : {false, true})
    {
        Scene scene;
        scene.throwIf = [](const double* x) { return x[0] > 0.3 && x[0] < 0.35; };
        PlannerSettings settings = settingsFor(1);
        settings.rethrowExceptions = rethrow;
        scene.plan(settings);
        if (rethrow)
            EXPECT_THROW(scene.solve(), std::runtime_error);
        else
            EXPECT_EQ(scene.solve(), ob::PlannerStatus::CRASH);
        EXPECT_NE(scene.planner->getReport().error, "");
        EXPECT_GT(scene.planner->getReport().expansions, 0U) << "what was done before the failure";
        scene.throwIf = {};
        EXPECT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(scene.planner->getReport().error, "");
    }
}

TEST(QueryInputs, ChecksOfStartsAndGoalsAreCounted)
{
    Scene scene;
    scene.start = {{0.5, 0.5}, {0.1, 0.1}};
    scene.plan(settingsFor(1));
    scene.calls = 0;
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const SearchReport& report = scene.planner->getReport();
    EXPECT_LE(report.checksUsed, report.checksTotal);
    EXPECT_EQ(report.checksTotal, report.demandedChecks);
}
}  // namespace
}  // namespace specplan::test
