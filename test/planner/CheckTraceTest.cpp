// SPDX-License-Identifier: BSD-3-Clause
// Traces of checks: what is recorded, and that the same search runs again without the checker.
#include "specplan/planner/CheckTrace.h"

#include <gtest/gtest.h>

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>

#include "Scene.h"

namespace specplan::test
{
namespace
{
using planner::CheckTrace;

PlannerSettings settings(unsigned threads, const std::string& executor)
{
    PlannerSettings settings = settingsFor(threads, "runahead", executor);
    settings.resolution = 0.05;
    settings.anytime = false;
    settings.weight = 1.0;  // a search that is long enough for many workers
    return settings;
}

SearchReport solved(Scene& scene, const PlannerSettings& how, const std::shared_ptr<CheckTrace>& trace)
{
    scene.plan(how).setCheckTrace(trace);
    scene.calls = 0;
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    return scene.planner->getReport();
}

/// Start and goal are checked before the search, and are not in the trace.
constexpr int kTerminals = 2;

TEST(CheckTrace, OneThreadIsReplayedWithoutTheChecker)
{
    Scene scene;
    scene.latency = std::chrono::microseconds(50);
    const auto trace = std::make_shared<CheckTrace>();
    const SearchReport recorded = solved(scene, settings(1, "threads"), trace);
    const int calls = scene.calls;
    EXPECT_GT(calls, 100);
    EXPECT_EQ(trace->size() + kTerminals, recorded.checksTotal);

    const SearchReport replayed = solved(scene, settings(1, "virtual"), trace);
    EXPECT_LE(scene.calls, kTerminals) << "start and goal, which are checked before the search";
    EXPECT_EQ(replayed.orderHash, recorded.orderHash);
    EXPECT_EQ(replayed.cost, recorded.cost);
    EXPECT_EQ(replayed.checksTotal, recorded.checksTotal);
    EXPECT_NEAR(replayed.waitTime, recorded.waitTime, 0.02 * recorded.waitTime) << "the durations of the checks";
    EXPECT_GT(replayed.searchTime, 0.0) << "the search's own work counts";
    EXPECT_NEAR(replayed.virtualTime, replayed.waitTime + replayed.searchTime, 1e-9);
}

TEST(CheckTrace, WhatMoreWorkersCheckBesidesIsCheckedOnce)
{
    Scene scene;
    scene.latency = std::chrono::microseconds(50);
    const auto trace = std::make_shared<CheckTrace>();
    const SearchReport recorded = solved(scene, settings(1, "threads"), trace);
    const std::size_t known = trace->size();

    const SearchReport many = solved(scene, settings(16, "virtual"), trace);
    EXPECT_EQ(many.orderHash, recorded.orderHash);
    EXPECT_EQ(many.threads, 16U);
    EXPECT_GT(trace->size(), known) << "some were in vain";
    EXPECT_GE(scene.calls, static_cast<int>(trace->size() - known)) << "a check looks at one state or more";
    EXPECT_LT(many.virtualTime, 0.25 * recorded.wallTime);
    EXPECT_GT(many.virtualTime, recorded.wallTime / 16.0);

    const std::size_t then = trace->size();
    solved(scene, settings(16, "virtual"), trace);
    EXPECT_LE(scene.calls, 2 + 20 * static_cast<int>(trace->size() - then)) << "those are known now";
}

TEST(CheckTrace, ClearanceOfMotionsIsKeptToo)
{
    Scene scene;
    const auto objective = std::make_shared<ob::MaximizeMinClearanceObjective>(scene.setup.getSpaceInformation());
    scene.setup.setOptimizationObjective(objective);
    for (const bool inChecks : {true, false})
    {
        const auto trace = std::make_shared<CheckTrace>();
        PlannerSettings how = settings(1, "threads");
        how.objectiveInChecks = inChecks;
        const SearchReport recorded = solved(scene, how, trace);
        how.executor = "virtual";
        const SearchReport replayed = solved(scene, how, trace);
        EXPECT_LE(scene.calls, 2);
        EXPECT_EQ(replayed.cost, recorded.cost);
        EXPECT_EQ(replayed.orderHash, recorded.orderHash);
    }
}

TEST(CheckTrace, TellsEachCheckInOrder)
{
    for (const unsigned threads : {1U, 4U})
    {
        Scene scene;
        scene.latency = std::chrono::microseconds(20);
        const SearchReport report = solved(scene, settings(threads, "threads"), std::make_shared<CheckTrace>());
        std::uint64_t count = 0;
        std::uint64_t motions = 0;
        std::uint64_t used = 0;
        double last = 0.0;
        scene.planner->visitChecks(
            [&](const SpeculativeAStar::CheckRun& check)
            {
                ++count;
                motions += check.to != nullptr ? 1 : 0;
                used += check.used ? 1 : 0;
                EXPECT_GE(check.start, last);
                EXPECT_GE(check.seconds, check.to == nullptr ? 20e-6 : 0.0);
                EXPECT_LT(check.worker, threads);
                const double x = scene.values(check.from)[0];
                EXPECT_TRUE(check.valid || check.to != nullptr || std::abs(x - 0.5) <= 0.051) << x;
                last = check.start;
            });
        EXPECT_EQ(count + kTerminals, report.checksTotal);
        EXPECT_GT(motions, 0U);
        EXPECT_LT(motions, count);
        EXPECT_LE(used, report.checksUsed);
        EXPECT_GE(used + 2, report.checksUsed) << "start and goal are checked by OMPL";
    }
}

TEST(CheckTrace, WithoutOneNothingIsKept)
{
    Scene scene;
    solved(scene, settings(1, "threads"), {});
    scene.planner->visitChecks([](const SpeculativeAStar::CheckRun&) { FAIL(); });
}
}  // namespace
}  // namespace specplan::test
