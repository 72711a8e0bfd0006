// SPDX-License-Identifier: BSD-3-Clause
// What is said of a search that has found no path.
#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "Scene.h"
#include "specplan/planner/Advice.h"
#include "specplan/planner/OmplCompat.h"

namespace specplan::test
{
namespace
{
bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

SearchReport reportOf(const LatticeSearchReport& search)
{
    SearchReport report;
    report.searches = {search};
    return report;
}

TEST(Advice, ATimeOutTellsHowFarEachLatticeWasSearched)
{
    Scene scene;
    scene.closed = true;
    PlannerSettings settings = settingsFor(1);
    scene.plan(settings);
    scene.setup.getProblemDefinition()->setOptimizationObjective(
        std::make_shared<ob::PathLengthOptimizationObjective>(scene.setup.getSpaceInformation()));
    int asked = 0;
    EXPECT_EQ(scene.solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 4000; })),
              ob::PlannerStatus::APPROXIMATE_SOLUTION);
    const SearchReport& report = scene.planner->getReport();
    ASSERT_GE(report.searches.size(), 2U);
    EXPECT_EQ(report.searches.front().end, "no path");
    EXPECT_EQ(report.searches.front().spacing, 2.0);
    EXPECT_EQ(report.searches.back().end, "stopped");
    EXPECT_EQ(report.searches.back().spacing, 1.0);
    std::uint64_t expansions = 0;
    std::uint64_t checks = 0;
    for (const LatticeSearchReport& search : report.searches)
    {
        expansions += search.expansions;
        checks += search.checksUsed;
        EXPECT_LE(static_cast<double>(search.expansions), search.states);
    }
    EXPECT_EQ(expansions, report.expansions);
    EXPECT_EQ(checks, report.checksUsed);
    EXPECT_GT(report.distanceToGoal, 0.0);
    EXPECT_TRUE(has(report.advice, "Coarser lattices have no path")) << report.advice;
}

TEST(Advice, AnExhaustedLatticeDoesNotWantTime)
{
    Scene scene;
    scene.closed = true;
    PlannerSettings settings = settingsFor(1);
    settings.spacing = {0.05};
    scene.plan(settings);
    EXPECT_EQ(scene.solve(), planner::kInfeasible);
    const SearchReport& report = scene.planner->getReport();
    EXPECT_EQ(report.searches.back().end, "no path");
    EXPECT_TRUE(has(report.advice, "smaller spacing")) << report.advice;
    EXPECT_TRUE(has(report.advice, "longer time limit does not help")) << report.advice;
}

TEST(Advice, NothingIsAdvisedWhereThereIsAPath)
{
    Scene scene;
    scene.plan(settingsFor(1));
    int asked = 0;
    EXPECT_NE(scene.solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 20; })),
              ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_NE(scene.planner->getReport().advice, "");
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(scene.planner->getReport().advice, "");
    EXPECT_EQ(scene.planner->getReport().searches.back().end, "solved");
}

TEST(Advice, FitsTheSearch)
{
    PlannerSettings settings;
    const LatticeSearchReport optimal{1.0, 1.0, "stopped", 100, 100, 1e6};
    EXPECT_TRUE(has(planner::advise(reportOf(optimal), settings, true, 1), "weight of 3"));
    EXPECT_TRUE(has(planner::advise(reportOf(optimal), settings, true, 1), "Lazy evaluation"));
    EXPECT_FALSE(has(planner::advise(reportOf(optimal), settings, false, 1), "Lazy evaluation"));
    EXPECT_FALSE(has(planner::advise(reportOf(optimal), settings, true, 1), "larger spacing"));
    settings.spacing = {0.001};
    EXPECT_TRUE(has(planner::advise(reportOf(optimal), settings, true, 1), "larger spacing"));

    const LatticeSearchReport hasty{1.0, 10.0, "stopped", 100, 100, 1e6};
    EXPECT_FALSE(has(planner::advise(reportOf(hasty), settings, true, 1), "weight of 3"));
    SearchReport slow = reportOf(hasty);
    slow.wallTime = 10.0;
    slow.waitTime = 9.0;
    EXPECT_TRUE(has(planner::advise(slow, settings, true, 8), "8 processors"));
    EXPECT_FALSE(has(planner::advise(slow, settings, true, 1), "processors"));

    const LatticeSearchReport exhausted{1.0, 1.0, "no path", 100, 100, 100.0};
    PlannerSettings once;
    once.anytime = false;
    EXPECT_TRUE(has(planner::advise(reportOf(exhausted), once, true, 1), "Set anytime to 1"));
    EXPECT_TRUE(has(planner::advise(reportOf(exhausted), PlannerSettings(), true, 1), "narrowest passage"));
    EXPECT_EQ(planner::advise(SearchReport(), settings, true, 1), "");
}
}  // namespace
}  // namespace specplan::test
