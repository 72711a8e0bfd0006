// SPDX-License-Identifier: BSD-3-Clause
// What the planner promises, for every kind of space, goal and objective that OMPL has.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/MinimaxObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include "ReferenceDijkstra.h"
#include "SpaceCases.h"
#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace
{
namespace og = ompl::geometric;

/// A checker made of a clearance.
class ClearanceChecker : public ob::StateValidityChecker
{
public:
    ClearanceChecker(const ob::SpaceInformationPtr& si, const SpaceCase& problem)
        : ob::StateValidityChecker(si), problem_(problem)
    {
    }

    bool isValid(const ob::State* state) const override
    {
        return clearance(state) > 0.0;
    }

    double clearance(const ob::State* state) const override
    {
        std::vector<double> reals;
        si_->getStateSpace()->copyToReals(reals, state);
        return problem_.clearance(reals);
    }

private:
    const SpaceCase& problem_;
};

double firstValue(const ob::SpaceInformation& si, const ob::State* state)
{
    std::vector<double> reals;
    si.getStateSpace()->copyToReals(reals, state);
    return reals.front();
}

class Integral : public ob::StateCostIntegralObjective
{
public:
    explicit Integral(const ob::SpaceInformationPtr& si) : ob::StateCostIntegralObjective(si, true)
    {
    }

    ob::Cost stateCost(const ob::State* state) const override
    {
        return ob::Cost(1.0 + std::abs(firstValue(*si_, state)));
    }
};

class Work : public ob::MechanicalWorkOptimizationObjective
{
public:
    explicit Work(const ob::SpaceInformationPtr& si) : ob::MechanicalWorkOptimizationObjective(si, 0.1)
    {
    }

    ob::Cost stateCost(const ob::State* state) const override
    {
        return ob::Cost(firstValue(*si_, state) * firstValue(*si_, state));
    }
};

class Worst : public ob::MinimaxObjective
{
public:
    explicit Worst(const ob::SpaceInformationPtr& si) : ob::MinimaxObjective(si)
    {
    }

    ob::Cost stateCost(const ob::State* state) const override
    {
        return ob::Cost(1.0 / (0.1 + si_->getStateValidityChecker()->clearance(state)));
    }
};

/// Going up the first axis costs twice as much as going down; ending costs, too.
class Uphill : public ob::OptimizationObjective
{
public:
    explicit Uphill(const ob::SpaceInformationPtr& si) : ob::OptimizationObjective(si)
    {
    }

    ob::Cost stateCost(const ob::State*) const override
    {
        return ob::Cost(1.0);
    }

    ob::Cost motionCost(const ob::State* from, const ob::State* to) const override
    {
        const bool up = firstValue(*si_, to) > firstValue(*si_, from);
        return ob::Cost(si_->distance(from, to) * (up ? 2.0 : 1.0));
    }

    ob::Cost motionCostHeuristic(const ob::State* from, const ob::State* to) const override
    {
        return ob::Cost(si_->distance(from, to));
    }

    ob::Cost initialCost(const ob::State*) const override
    {
        return ob::Cost(0.5);
    }

    ob::Cost terminalCost(const ob::State* state) const override
    {
        return ob::Cost(std::abs(firstValue(*si_, state)));
    }

    bool isSymmetric() const override
    {
        return false;
    }
};

ob::OptimizationObjectivePtr makeObjective(const std::string& kind, const ob::SpaceInformationPtr& si)
{
    if (kind == "Integral")
        return std::make_shared<Integral>(si);
    if (kind == "Work")
        return std::make_shared<Work>(si);
    if (kind == "Clearance")
        return std::make_shared<ob::MaximizeMinClearanceObjective>(si);
    if (kind == "Minimax")
        return std::make_shared<Worst>(si);
    if (kind == "Uphill")
        return std::make_shared<Uphill>(si);
    auto length = std::make_shared<ob::PathLengthOptimizationObjective>(si);
    if (kind == "Length")
        return length;
    auto several = std::make_shared<ob::MultiOptimizationObjective>(si);
    several->addObjective(length, 1.0);
    several->addObjective(std::make_shared<Integral>(si), 0.5);
    several->lock();
    return several;
}

/// Everything within some distance of a state.
class Ball : public ob::GoalRegion
{
public:
    Ball(const ob::SpaceInformationPtr& si, const ob::State* centre, double radius)
        : ob::GoalRegion(si), centre_(si->getStateSpace())
    {
        centre_ = centre;
        setThreshold(radius);
    }

    double distanceGoal(const ob::State* state) const override
    {
        return si_->distance(state, centre_.get());
    }

private:
    ob::ScopedState<> centre_;
};

/// The same with samples: its centre, for ever.
class SampleableBall : public ob::GoalSampleableRegion
{
public:
    SampleableBall(const ob::SpaceInformationPtr& si, const ob::State* centre, double radius)
        : ob::GoalSampleableRegion(si), centre_(si->getStateSpace())
    {
        centre_ = centre;
        setThreshold(radius);
    }

    double distanceGoal(const ob::State* state) const override
    {
        return si_->distance(state, centre_.get());
    }

    void sampleGoal(ob::State* state) const override
    {
        si_->copyState(state, centre_.get());
    }

    unsigned maxSampleCount() const override
    {
        return 1000000;
    }

private:
    ob::ScopedState<> centre_;
};

/// Only says yes or no.
class Predicate : public ob::Goal
{
public:
    Predicate(const ob::SpaceInformationPtr& si, const ob::State* centre, double radius)
        : ob::Goal(si), centre_(si->getStateSpace()), radius_(radius)
    {
        centre_ = centre;
    }

    bool isSatisfied(const ob::State* state) const override
    {
        return si_->distance(state, centre_.get()) < radius_;
    }

private:
    ob::ScopedState<> centre_;
    double radius_;
};

struct Contract
{
    std::size_t space;
    std::string goal;
    std::string objective;

    friend void PrintTo(const Contract& contract, std::ostream* out)
    {
        *out << spaceCases()[contract.space].name << ", " << contract.goal << ", " << contract.objective;
    }
};

/// One problem, built anew for each run.
class Problem
{
public:
    explicit Problem(const Contract& contract)
        : problem(spaceCases()[contract.space]), si(std::make_shared<ob::SpaceInformation>(problem.make()))
    {
        si->setStateValidityChecker(std::make_shared<ClearanceChecker>(si, problem));
        si->getStateSpace()->setLongestValidSegmentFraction(problem.validity);
        si->setup();
        objective = makeObjective(contract.objective, si);
        pdef = std::make_shared<ob::ProblemDefinition>(si);
        pdef->addStartState(state(problem.start));
        if (contract.goal == "TwoStarts")
            pdef->addStartState(state(problem.goals[1]));
        pdef->setOptimizationObjective(objective);
        radius = 0.3 * si->distance(state(problem.start).get(), state(problem.goals[0]).get());
        pdef->setGoal(makeGoal(contract.goal));
        settings.resolution = problem.resolution;
        settings.anytime = false;
        settings.weight = 1.0;
    }

    ob::ScopedState<> state(const std::vector<double>& reals) const
    {
        ob::ScopedState<> made(si->getStateSpace());
        if (auto* compound = dynamic_cast<ob::CompoundStateSpace*>(si->getStateSpace().get());
            compound != nullptr && problem.name == "FloorsAndPlace")
            made->as<ob::CompoundState>()->as<ob::DiscreteStateSpace::StateType>(1)->value = reals[0] > 0.5 ? 3 : 0;
        si->getStateSpace()->copyFromReals(made.get(), reals);
        return made;
    }

    ob::GoalPtr makeGoal(const std::string& kind)
    {
        const ob::ScopedState<> nearer = state(problem.goals[0]);
        if (kind == "Ball")
            return std::make_shared<Ball>(si, nearer.get(), radius);
        if (kind == "SampleableBall")
            return std::make_shared<SampleableBall>(si, nearer.get(), radius);
        if (kind == "Predicate")
            return std::make_shared<Predicate>(si, nearer.get(), radius);
        if (kind == "Lazy")
            return std::make_shared<ob::GoalLazySamples>(
                si,
                [this, given = 0](const ob::GoalLazySamples*, ob::State* sample) mutable
                {
                    si->copyState(sample, state(problem.goals[0]).get());
                    return given++ == 0;
                });
        auto goal = std::make_shared<ob::GoalStates>(si);
        goal->addState(nearer);
        if (kind == "TwoStates" || kind == "Threshold")
            goal->addState(state(problem.goals[1]));
        if (kind == "Threshold")
            goal->setThreshold(radius);
        return goal;
    }

    ob::PlannerStatus solve(unsigned threads, const std::string& executor)
    {
        settings.numThreads = threads;
        settings.executor = executor;
        planner = std::make_shared<SpeculativeAStar>(si, settings);
        planner->setProblemDefinition(pdef);
        planner->setup();
        return planner->solve(ob::timedPlannerTerminationCondition(60.0));
    }

    const SpaceCase& problem;
    ob::SpaceInformationPtr si;
    ob::OptimizationObjectivePtr objective;
    ob::ProblemDefinitionPtr pdef;
    PlannerSettings settings;
    double radius = 0.0;
    std::shared_ptr<SpeculativeAStar> planner;
};

class ContractTest : public testing::TestWithParam<Contract>
{
};

std::optional<ob::Cost> referenceCost(Problem& problem, const Contract& contract)
{
    std::vector<const ob::State*> starts;
    for (unsigned i = 0; i < problem.pdef->getStartStateCount(); ++i)
        starts.push_back(problem.pdef->getStartState(i));
    const ob::ScopedState<> nearer = problem.state(problem.problem.goals[0]);
    const ob::ScopedState<> other = problem.state(problem.problem.goals[1]);
    std::vector<const ob::State*> goals;
    const bool region = contract.goal == "Ball" || contract.goal == "Predicate";
    if (!region)
        goals.push_back(nearer.get());
    if (contract.goal == "TwoStates" || contract.goal == "Threshold")
        goals.push_back(other.get());
    std::function<bool(const ob::State*)> satisfies;
    if (region || contract.goal == "SampleableBall" || contract.goal == "Threshold")
        satisfies = [&](const ob::State* state) { return problem.pdef->getGoal()->isSatisfied(state); };
    ReferenceDijkstra reference(problem.si, *problem.objective, problem.settings, starts.front());
    return reference.solve(starts, goals, satisfies);
}

TEST_P(ContractTest, Holds)
{
    const Contract& contract = GetParam();
    std::optional<std::uint64_t> order;
    std::optional<double> cost;
    for (const auto& [threads, executor] : {std::pair{1U, "threads"}, {4U, "threads"}, {16U, "virtual"}})
    {
        Problem problem(contract);
        if (auto* lazy = dynamic_cast<ob::GoalLazySamples*>(problem.pdef->getGoal().get()))
            lazy->startSampling();
        ASSERT_EQ(problem.solve(threads, executor), ob::PlannerStatus::EXACT_SOLUTION)
            << problem.planner->getReport().status << ' ' << problem.planner->getReport().error;
        auto& path = *problem.pdef->getSolutionPath()->as<og::PathGeometric>();
        EXPECT_TRUE(path.check());
        EXPECT_TRUE(problem.pdef->getGoal()->isSatisfied(path.getStates().back()));
        bool startsRight = false;
        for (unsigned i = 0; i < problem.pdef->getStartStateCount(); ++i)
            startsRight =
                startsRight || problem.si->equalStates(path.getStates().front(), problem.pdef->getStartState(i));
        EXPECT_TRUE(startsRight);
        const SearchReport& report = problem.planner->getReport();
        EXPECT_NEAR(report.cost, path.cost(problem.objective).value(), 1e-9 * std::abs(report.cost));
        EXPECT_EQ(report.checksUsed, report.usedReady + report.usedAfterWait + report.usedInline);
        if (!order)
        {
            const std::optional<ob::Cost> best = referenceCost(problem, contract);
            ASSERT_TRUE(best);
            EXPECT_NEAR(report.cost, best->value(), 1e-9 * std::max(1.0, std::abs(report.cost)));
        }
        EXPECT_EQ(order.value_or(report.orderHash), report.orderHash);
        EXPECT_EQ(cost.value_or(report.cost), report.cost);
        order = report.orderHash;
        cost = report.cost;
    }
}

class LazyContractTest : public testing::TestWithParam<Contract>
{
};

/// Lazy evaluation finds a path of the same cost for fewer checks, and always the same one.
TEST_P(LazyContractTest, Holds)
{
    const Contract& contract = GetParam();
    Problem eager(contract);
    ASSERT_EQ(eager.solve(1, "threads"), ob::PlannerStatus::EXACT_SOLUTION);
    const SearchReport& eagerly = eager.planner->getReport();
    std::optional<std::uint64_t> order;
    for (const auto& [threads, executor] : {std::pair{1U, "threads"}, {4U, "threads"}, {16U, "virtual"}})
    {
        Problem problem(contract);
        problem.settings.evaluation = "lazy";
        ASSERT_EQ(problem.solve(threads, executor), ob::PlannerStatus::EXACT_SOLUTION)
            << problem.planner->getReport().status << ' ' << problem.planner->getReport().error;
        auto& path = *problem.pdef->getSolutionPath()->as<og::PathGeometric>();
        EXPECT_TRUE(path.check());
        EXPECT_TRUE(problem.pdef->getGoal()->isSatisfied(path.getStates().back()));
        const SearchReport& report = problem.planner->getReport();
        EXPECT_NEAR(report.cost, eagerly.cost, 1e-9 * eagerly.cost);
        EXPECT_NEAR(path.length(), report.cost, 1e-9 * report.cost);
        EXPECT_LE(report.checksUsed, eagerly.checksUsed);
        EXPECT_EQ(report.checksUsed, report.usedReady + report.usedAfterWait + report.usedInline);
        EXPECT_EQ(order.value_or(report.orderHash), report.orderHash);
        order = report.orderHash;
    }

    Problem weighted(contract);
    weighted.settings.evaluation = "lazy";
    weighted.settings.weight = 3.0;
    ASSERT_EQ(weighted.solve(1, "threads"), ob::PlannerStatus::EXACT_SOLUTION);
    const SearchReport& report = weighted.planner->getReport();
    EXPECT_EQ(report.weight, 3.0);
    EXPECT_GE(report.cost, eagerly.cost * (1.0 - 1e-9));
    EXPECT_LE(report.cost, eagerly.cost * 3.0);
    EXPECT_TRUE(weighted.pdef->getSolutionPath()->check());
}

std::vector<Contract> lazyContracts()
{
    std::vector<Contract> all;
    for (std::size_t space = 0; space < spaceCases().size(); ++space)
        for (const char* goal : {"State", "TwoStarts", "TwoStates"})
            all.push_back({space, goal, "Length"});
    return all;
}

std::vector<Contract> contracts()
{
    std::vector<Contract> all;
    for (std::size_t space = 0; space < spaceCases().size(); ++space)
    {
        for (const char* objective : {"Length", "Integral", "Work", "Clearance", "Minimax", "Several", "Uphill"})
            all.push_back({space, "State", objective});
        for (const char* goal : {"TwoStarts", "TwoStates", "Threshold", "Ball", "SampleableBall", "Predicate", "Lazy"})
            all.push_back({space, goal, "Length"});
    }
    return all;
}

std::string nameOf(const testing::TestParamInfo<Contract>& of)
{
    return spaceCases()[of.param.space].name + "_" + of.param.goal + "_" + of.param.objective;
}

INSTANTIATE_TEST_SUITE_P(All, ContractTest, testing::ValuesIn(contracts()), nameOf);
INSTANTIATE_TEST_SUITE_P(All, LazyContractTest, testing::ValuesIn(lazyContracts()), nameOf);
}  // namespace
}  // namespace specplan::test
