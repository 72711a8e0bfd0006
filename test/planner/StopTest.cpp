// SPDX-License-Identifier: BSD-3-Clause
// Stopped at any moment, solve() leaves no check behind, begins none, and goes on later as if nothing had happened.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <thread>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

/// A unit square with a ring around the start that has a gap on the far side; each motion has some 20 states inside.
class Ring
{
public:
    Ring(unsigned threads, const std::string& evaluation) : setup(std::make_shared<ob::RealVectorStateSpace>(2))
    {
        setup.getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(-1.0, 1.0);
        setup.getSpaceInformation()->setStateValidityCheckingResolution(0.003);
        setup.setStateValidityChecker([this](const ob::State* state) { return check(state); });
        ob::ScopedState<> start(setup.getStateSpace());
        ob::ScopedState<> goal(setup.getStateSpace());
        start[0] = start[1] = 0.0;
        goal[0] = 0.8;
        goal[1] = 0.0;
        setup.setStartAndGoalStates(start, goal);
        PlannerSettings settings;
        settings.numThreads = threads;
        settings.evaluation = evaluation;
        settings.spacing = {0.1};
        settings.weight = 1.0;
        planner = std::make_shared<SpeculativeAStar>(setup.getSpaceInformation(), settings);
        setup.setPlanner(planner);
        setup.setup();
    }

    /// Solves until so many calls of the checker have begun, or to the end.
    ob::PlannerStatus solveUntil(int calls)
    {
        stopAt_ = calls;
        told_ = false;
        begunAfter = 0;
        return planner->solve(ob::PlannerTerminationCondition(
            [this]
            {
                if (begun >= stopAt_)
                    told_ = true;
                return told_.load();
            }));
    }

    og::SimpleSetup setup;
    std::shared_ptr<SpeculativeAStar> planner;
    std::atomic<int> begun{0};
    std::atomic<int> running{0};
    std::atomic<int> begunAfter{0};  ///< the search thread had been told

private:
    bool check(const ob::State* state)
    {
        ++running;
        ++begun;
        begunAfter += told_ ? 1 : 0;
        std::this_thread::sleep_for(std::chrono::microseconds(20));
        const auto* at = state->as<ob::RealVectorStateSpace::StateType>();
        const double radius = std::hypot(at->values[0], at->values[1]);
        --running;
        return std::abs(radius - 0.5) > 0.1 || (at->values[0] < 0.0 && std::abs(at->values[1]) < 0.2);
    }

    int stopAt_ = 0;
    std::atomic<bool> told_{false};
};

constexpr int kNever = 1 << 30;

TEST(Stop, AtAnyMomentNoCheckBeginsAnyMoreAndTheSearchGoesOnLater)
{
    std::mt19937 random(7);
    for (const std::string evaluation : {"eager", "lazy"})
    {
        Ring whole(1, evaluation);
        ASSERT_EQ(whole.solveUntil(kNever), ob::PlannerStatus::EXACT_SOLUTION);
        const double length = whole.planner->getReport().cost;
        std::uniform_int_distribution<int> moment(1, whole.begun / 2);
        int stops = 0;
        while (stops < 100)
            for (const unsigned threads : {1U, 2U, 3U, 8U, 16U, 128U})
            {
                Ring ring(threads, evaluation);
                ob::PlannerStatus status = ob::PlannerStatus::UNKNOWN;
                for (int begun = moment(random); status != ob::PlannerStatus::EXACT_SOLUTION;
                     begun = ring.begun + moment(random))
                {
                    status = ring.solveUntil(begun);
                    ASSERT_EQ(ring.running, 0);
                    EXPECT_LE(ring.begunAfter, static_cast<int>(threads)) << "those that were being taken just then";
                    stops += status != ob::PlannerStatus::EXACT_SOLUTION ? 1 : 0;
                }
                EXPECT_EQ(ring.planner->getReport().orderHash, whole.planner->getReport().orderHash)
                    << evaluation << " " << threads;
                EXPECT_EQ(ring.planner->getReport().cost, length);
                const SearchReport& report = ring.planner->getReport();
                EXPECT_LE(report.checksUsed, report.checksTotal + 1);
            }
    }
}

TEST(Stop, ToldBeforeItChecksNoMoreThanAStart)
{
    Ring ring(4, "eager");
    EXPECT_EQ(ring.planner->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
    EXPECT_LE(ring.begun, 1);
}

/// One that must not be stopped inside, and is not thread-safe.
class SlowValidator : public ob::MotionValidator
{
public:
    using MotionValidator::MotionValidator;

    bool checkMotion(const ob::State*, const ob::State*) const override
    {
        EXPECT_EQ(++running_, 1);
        ++begun;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        --running_;
        return true;
    }

    bool checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>&) const override
    {
        return checkMotion(from, to);
    }

    mutable std::atomic<int> begun{0};

private:
    mutable std::atomic<int> running_{0};
};

TEST(Stop, WorkersThatWaitForASharedMotionValidatorDoNotBegin)
{
    Ring ring(16, "eager");
    auto validator = std::make_shared<SlowValidator>(ring.setup.getSpaceInformation());
    ring.setup.getSpaceInformation()->setMotionValidator(validator);
    ring.setup.getSpaceInformation()->setup();
    std::atomic<int> atStop{0};
    const auto told = [&]
    {
        if (validator->begun < 10)
            return false;
        if (atStop == 0)
            atStop = validator->begun.load();
        return true;
    };
    EXPECT_NE(ring.planner->solve(ob::PlannerTerminationCondition(told)), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_LE(validator->begun, atStop + 2);
}
}  // namespace
}  // namespace specplan::test
