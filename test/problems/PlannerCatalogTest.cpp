// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/PlannerCatalog.h"

#include <gtest/gtest.h>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "TemporaryFolder.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace
{
using test::complaintOf;

ompl::base::SpaceInformationPtr makeSpaceInformation()
{
    return std::make_shared<ompl::base::SpaceInformation>(std::make_shared<ompl::base::SE2StateSpace>());
}

TEST(PlannerCatalog, MakesEveryPlannerItNames)
{
    const auto si = makeSpaceInformation();
    EXPECT_GT(plannerNames().size(), 30U);
    for (const std::string& name : plannerNames())
    {
        EXPECT_TRUE(isPlannerName(name));
        EXPECT_NE(makePlanner(name, {}, si), nullptr) << name;
    }
}

TEST(PlannerCatalog, KnowsTheNamesOfOmplApp)
{
    for (const char* name : {"est", "rrt", "sbl", "prm", "kpiece", "bkpiece", "lbkpiece", "rrtconnect", "trrt",
                             "stride", "pdst", "aps", "spars2", "lazyprmstar", "cforest", "bfmt"})
        EXPECT_TRUE(isPlannerName(name)) << name;
    EXPECT_EQ(makePlanner("kpiece", {}, makeSpaceInformation())->getName(), "KPIECE1");
    for (const char* name : {"", "RRTConnec", "RRTConnect2"})
        EXPECT_FALSE(isPlannerName(name)) << name;
}

TEST(PlannerCatalog, SetsParametersAndName)
{
    const auto planner = makePlanner("RRTConnect", {{"range", "2.5"}, {"name", "long steps"}}, makeSpaceInformation());
    EXPECT_EQ(planner->getName(), "long steps");
    std::string range;
    ASSERT_TRUE(planner->params().getParam("range", range));
    EXPECT_EQ(std::stod(range), 2.5);
}

TEST(PlannerCatalog, RefusesWhatItDoesNotKnowInOneLine)
{
    const auto si = makeSpaceInformation();
    const auto complaint = [&si](const std::string& name, const std::map<std::string, std::string>& parameters)
    { return complaintOf<InputError>([&] { static_cast<void>(makePlanner(name, parameters, si)); }); };
    EXPECT_EQ(complaint("Teleport", {}).rfind("planner 'Teleport' is not known", 0), 0U);
    EXPECT_EQ(complaint("RRT", {{"colour", "red"}}), "planner RRT: expected one of its parameters, found 'colour'");
    EXPECT_EQ(complaint("RRT", {{"range", "far"}}), "planner RRT: range cannot be 'far', expected 0.:1.:10000.");
    EXPECT_EQ(complaint("SpeculativeAStar", {{"executor", "quantum"}}),
              "planner SpeculativeAStar: executor cannot be 'quantum', expected threads,virtual");
}
}  // namespace
}  // namespace specplan::problems
