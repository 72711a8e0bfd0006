// SPDX-License-Identifier: BSD-3-Clause
// What comes out is right: ends, cost, validity by the user's own motion validator, and the same for every number of
// threads.
#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <set>

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "Scene.h"

namespace specplan::test
{
namespace
{
TEST(Path, EndsInStartAndGoalOffTheLatticeAndPassesCheckInAnyDimension)
{
    for (const unsigned dimension : {1U, 2U, 3U, 4U})
    {
        Scene scene(dimension);
        if (dimension == 1)
            scene.setup.setStateValidityChecker([](const ob::State*) { return true; });
        scene.goals[0][0] = 0.8765;
        scene.goals[0].back() = 0.8642;
        scene.plan(settingsFor(4));
        ASSERT_EQ(scene.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION) << dimension << " dimensions";
        EXPECT_EQ(scene.values(scene.path().getState(0)), scene.start[0]);
        EXPECT_EQ(scene.values(scene.path().getStates().back()), scene.goals[0]);
        EXPECT_TRUE(scene.path().check());
        EXPECT_NEAR(scene.planner->getReport().cost, scene.path().length(), 1e-9);
    }
}

TEST(Path, ThePolicyNoneChecksNothingAheadInBothEvaluations)
{
    for (const std::string evaluation : {"eager", "lazy"})
    {
        std::uint64_t order = 0;
        for (const std::string policy : {"runahead", "none"})
        {
            Scene scene;
            PlannerSettings settings = settingsFor(8, policy, "virtual");
            settings.evaluation = evaluation;
            settings.weight = 1.0;
            scene.plan(settings);
            ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
            const SearchReport& report = scene.planner->getReport();
            EXPECT_EQ(report.evaluation, evaluation);
            EXPECT_EQ(report.speculativeChecks > 0, policy != "none") << evaluation << ", " << policy;
            if (policy == "none")
            {
                EXPECT_EQ(report.orderHash, order) << evaluation;
            }
            order = report.orderHash;
        }
    }
}

TEST(Path, TheReportTellsTheEvaluationThatWasPossible)
{
    Scene scene;
    PlannerSettings settings = settingsFor(1);
    settings.evaluation = "lazy";
    scene.plan(settings);
    scene.setup.getProblemDefinition()->setOptimizationObjective(
        std::make_shared<ob::StateCostIntegralObjective>(scene.setup.getSpaceInformation()));
    ASSERT_EQ(scene.solve(ob::exactSolnPlannerTerminationCondition(scene.setup.getProblemDefinition())),
              ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.planner->getReport().evaluation, "eager");
}

TEST(Path, IsTheSameForEveryThreadCountPolicyAndExecutorWithMotionChecks)
{
    for (const double resolution : {0.05, 0.12})
        for (const bool cornerCutting : {true, false})
        {
            std::string sequential;
            for (const unsigned threads : {1U, 2U, 4U, 8U, 32U})
                for (const std::string policy : {"none", "direction", "runahead"})
                    for (const std::string executor : {"threads", "virtual"})
                    {
                        Scene scene(3);
                        scene.start = {{0.1, 0.1, 0.1}, {0.2, 0.33, 0.2}};
                        scene.goals = {{0.9, 0.12, 0.9}, {0.91, 0.31, 0.47}};
                        PlannerSettings settings = settingsFor(threads, policy, executor);
                        settings.resolution = resolution;
                        settings.cornerCutting = cornerCutting;
                        scene.plan(settings);
                        ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
                        EXPECT_TRUE(scene.path().check());
                        const SearchReport& report = scene.planner->getReport();
                        const std::string answer = std::to_string(report.orderHash) + " " +
                                                   std::to_string(report.cost) + " " +
                                                   std::to_string(report.checksUsed);
                        if (sequential.empty())
                            sequential = answer;
                        EXPECT_EQ(answer, sequential) << threads << " " << policy << " " << executor;
                    }
        }
}

TEST(Path, TakesTheBestOfSeveralStartsAndGoals)
{
    Scene scene;
    scene.start = {{0.1, 0.1}, {0.33, 0.91}, {0.2, 0.2}};
    scene.goals = {{0.9, 0.1}, {0.612, 0.903}, {0.5, 0.5}};
    scene.plan(settingsFor(2));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.values(scene.path().getState(0)), scene.start[1]);
    EXPECT_EQ(scene.values(scene.path().getStates().back()), scene.goals[1]);
    EXPECT_TRUE(scene.path().check());
}

TEST(Path, GoesStraightWhereStartAndGoalShareACell)
{
    Scene scene;
    scene.start = {{0.1, 0.1}, {0.2031, 0.2052}};
    scene.goals = {{0.2066, 0.2019}};
    scene.plan(settingsFor(2));
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.path().getStateCount(), 2U);
}

TEST(Path, CostIsWithinTheWeight)
{
    double optimum = 0.0;
    for (const double weight : {1.0, 1.5, 10.0})
    {
        Scene scene;
        PlannerSettings settings = settingsFor(2);
        settings.weight = weight;
        scene.plan(settings);
        ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        if (weight == 1.0)
            optimum = scene.path().length();
        EXPECT_GE(scene.path().length(), optimum - 1e-9);
        EXPECT_LE(scene.path().length(), weight * optimum + 1e-9);
    }
}

TEST(Path, StatesAreCheckedAtMostOnceAndNeverSharedBetweenThreads)
{
    Scene scene;
    std::mutex mutex;
    std::map<std::vector<double>, int> seen;
    std::set<const ob::State*> held;
    bool shared = false;
    scene.setup.setStateValidityChecker(
        [&](const ob::State* state)
        {
            {
                const std::lock_guard lock(mutex);
                ++seen[scene.values(state)];
                shared = shared || !held.insert(state).second;
            }
            const bool valid = scene.isValid(state);
            const std::lock_guard lock(mutex);
            held.erase(state);
            return valid;
        });
    PlannerSettings settings = settingsFor(8);
    settings.spacing = {0.01};
    scene.setup.getSpaceInformation()->setStateValidityCheckingResolution(0.02);  // one segment a step: no inner states
    scene.plan(settings);
    scene.latency = std::chrono::microseconds(20);
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_FALSE(shared);
    for (const auto& [state, times] : seen)
        EXPECT_LE(times, 1) << state[0] << ", " << state[1];
    const SearchReport& report = scene.planner->getReport();
    EXPECT_EQ(report.checksTotal, seen.size()) << "start and goal count, too";
}

/// Forbids one diagonal; counts how many threads are inside at once.
class OneWay : public ob::MotionValidator
{
public:
    explicit OneWay(const ob::SpaceInformationPtr& si) : ob::MotionValidator(si)
    {
    }

    bool checkMotion(const ob::State* from, const ob::State* to) const override
    {
        const int now = ++inside;
        int seen = most;
        while (now > seen && !most.compare_exchange_weak(seen, now))
        {
        }
        std::this_thread::sleep_for(std::chrono::microseconds(5));
        const double* a = from->as<ob::RealVectorStateSpace::StateType>()->values;
        const double* b = to->as<ob::RealVectorStateSpace::StateType>()->values;
        --inside;
        return !(b[0] > a[0] + 1e-9 && b[1] > a[1] + 1e-9);
    }

    bool checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>&) const override
    {
        return checkMotion(from, to);
    }

    static std::atomic<int> inside;
    static std::atomic<int> most;
};

std::atomic<int> OneWay::inside{0};
std::atomic<int> OneWay::most{0};

TEST(Path, AUsersMotionValidatorDecidesAndIsNeverEnteredTwiceUnlessThereIsOnePerWorker)
{
    for (const bool perWorker : {false, true})
    {
        OneWay::most = 0;
        Scene scene;
        const auto& si = scene.setup.getSpaceInformation();
        si->setMotionValidator(std::make_shared<OneWay>(si));
        PlannerSettings settings = settingsFor(8);
        settings.resolution = 0.05;
        scene.plan(settings);
        std::atomic<int> made{0};
        if (perWorker)
            scene.planner->setMotionValidatorAllocator(
                [&made](const ob::SpaceInformationPtr& information, unsigned)
                {
                    ++made;
                    return std::make_shared<OneWay>(information);
                });
        ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(scene.path().check());
        EXPECT_GT(scene.path().length(), 1.59);  // no diagonal up
        EXPECT_EQ(made, perWorker ? 8 : 0);
        EXPECT_GE(OneWay::most, perWorker ? 2 : 1);
        EXPECT_LE(OneWay::most, perWorker ? 8 : 1);
    }
}

/// A checker that is not thread-safe: notices when two threads are inside.
class Fragile : public ob::StateValidityChecker
{
public:
    using ob::StateValidityChecker::StateValidityChecker;

    bool isValid(const ob::State*) const override
    {
        clashes += inside.exchange(true) ? 1 : 0;
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        inside = false;
        return true;
    }

    mutable std::atomic<bool> inside{false};
    mutable std::atomic<int> clashes{0};
};

TEST(Path, EveryWorkerCanHaveACheckerOfItsOwn)
{
    Scene scene;
    std::vector<std::shared_ptr<Fragile>> checkers;
    PlannerSettings settings = settingsFor(4);
    settings.resolution = 0.05;
    scene.plan(settings);
    scene.planner->setStateValidityCheckerAllocator(
        [&checkers](const ob::SpaceInformationPtr& si, unsigned worker)
        {
            EXPECT_EQ(worker, checkers.size());
            checkers.push_back(std::make_shared<Fragile>(si));
            return checkers.back();
        });
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    ASSERT_EQ(checkers.size(), 4U);
    for (const auto& checker : checkers)
        EXPECT_EQ(checker->clashes, 0);
}

/// Path length, told apart from OMPL's own by its type.
class Length : public ob::PathLengthOptimizationObjective
{
public:
    using ob::PathLengthOptimizationObjective::PathLengthOptimizationObjective;
};

TEST(Path, AUsersObjectiveGivesTheSameCostAsTheBuiltInOne)
{
    double builtIn = 0.0;
    for (const bool own : {false, true})
    {
        Scene scene;
        PlannerSettings settings = settingsFor(2);
        settings.resolution = 0.04;
        const auto& si = scene.setup.getSpaceInformation();
        scene.setup.setOptimizationObjective(own ? std::make_shared<Length>(si)
                                                 : std::make_shared<ob::PathLengthOptimizationObjective>(si));
        scene.plan(settings);
        ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        if (!own)
            builtIn = scene.planner->getReport().cost;
        EXPECT_NEAR(scene.planner->getReport().cost, builtIn, 1e-9);
    }
}

TEST(Path, TheIntermediateCallbackGetsTheSolutionFromStartToGoal)
{
    Scene scene;
    scene.plan(settingsFor(2));
    int called = 0;
    scene.setup.getProblemDefinition()->setIntermediateSolutionCallback(
        [&](const ob::Planner* planner, const std::vector<const ob::State*>& states, ob::Cost cost)
        {
            ++called;
            EXPECT_EQ(planner, scene.planner);
            EXPECT_EQ(scene.values(states.front()), scene.start[0]);
            EXPECT_EQ(scene.values(states.back()), scene.goals[0]);
            EXPECT_GT(cost.value(), 1.0);
        });
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(called, 1);
}

TEST(Path, ExplorationShowsWhatBecameOfEachState)
{
    Scene scene;
    scene.plan(settingsFor(16, "direction", "virtual"));
    std::vector<std::vector<double>> expanded;
    scene.planner->setExpansionObserver([&](const ob::State* state) { expanded.push_back(scene.values(state)); });
    ASSERT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    std::map<SpeculativeAStar::StateFate, std::uint64_t> fates;
    scene.planner->visitStates([&](const ob::State*, SpeculativeAStar::StateFate fate) { ++fates[fate]; });
    const SearchReport& report = scene.planner->getReport();
    EXPECT_EQ(expanded.size(), report.expansions);
    EXPECT_EQ(expanded.front(), scene.start[0]);
    EXPECT_EQ(fates[SpeculativeAStar::StateFate::Expanded], report.expansions);
    EXPECT_GT(fates[SpeculativeAStar::StateFate::Invalid], 0U);
    EXPECT_GT(fates[SpeculativeAStar::StateFate::CheckedUnused], 0U);
    EXPECT_GT(report.speedup, 3.0);
}
}  // namespace
}  // namespace specplan::test
