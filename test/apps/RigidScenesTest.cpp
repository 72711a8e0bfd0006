// SPDX-License-Identifier: BSD-3-Clause
#include "RigidScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "Command.h"
#include "specplan/problems/fcl/RigidBodySetup.h"

namespace specplan::make_meshes
{
namespace
{
namespace ob = ompl::base;

std::string contents(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

TEST(RigidScenes, FilesAreWhatTheGeneratorWrites)
{
    const test::TemporaryFolder folder;
    for (const RigidScene& scene : makeAllRigidScenes())
    {
        writeRigidScene(folder / ".", scene);
        for (const char* ending : {".cfg", "-robot.obj", scene.map ? "-world.bt" : "-world.obj"})
            EXPECT_EQ(folder.read(scene.name + ending), contents(test::scene(scene.name + ending))) << scene.name;
    }
    if (!problems::hasOctoMap())
        return;
    const auto isRigid = [](const std::filesystem::directory_entry& entry)
    {
        const std::filesystem::path extension = entry.path().extension();
        return extension == ".cfg" || extension == ".obj" || extension == ".bt";
    };
    EXPECT_EQ(std::count_if(std::filesystem::directory_iterator(SPECPLAN_SCENES_DIR),
                            std::filesystem::directory_iterator(), isRigid),
              folder.files());
}

TEST(RigidScenes, OmplFindsAWay)
{
    std::vector<std::string> scenes{"office.cfg", "piano.cfg"};
    if (problems::hasOctoMap())
        scenes.emplace_back("scan.cfg");
    for (const std::string& scene : scenes)
    {
        const test::Outcome outcome =
            test::call("plan '" + test::scene(scene) + "' --planner RRTConnect --time-limit 200s --json");
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
    }
}

/// Turn, then push. Nothing is shorter than the distance of start and goal, and this is as long.
TEST(RigidScenes, PassageHasTheSolutionThatItSays)
{
    const problems::RigidBodySetup problem(problems::readOmplAppProblem(test::scene("passage.cfg")));
    const auto setup = problem.makeSetup();
    const auto& si = setup->getSpaceInformation();
    si->getStateSpace()->setLongestValidSegmentFraction(0.0005);
    si->setup();
    const ob::State* start = setup->getProblemDefinition()->getStartState(0);
    const ob::State* goal = setup->getGoal()->as<ob::GoalState>()->getState();
    ob::ScopedState<ob::SE3StateSpace> turned(si);
    turned->setXYZ(-1.5, 0.0, 0.0);
    turned->rotation().setIdentity();
    EXPECT_TRUE(si->checkMotion(start, turned.get()));
    EXPECT_TRUE(si->checkMotion(turned.get(), goal));
    EXPECT_FALSE(si->checkMotion(start, goal)) << "to turn on the way does not work";
    const double shortest = 3.0 + std::numbers::pi / 4.0;
    EXPECT_NEAR(si->distance(start, goal), shortest, 1e-6);
    EXPECT_NEAR(si->distance(start, turned.get()) + si->distance(turned.get(), goal), shortest, 1e-6);
    ob::ScopedState<ob::SE3StateSpace> askew(si);
    askew->setXYZ(0.0, 0.0, 0.0);
    askew->rotation().setAxisAngle(0.0, 0.0, 1.0, 0.3);
    EXPECT_FALSE(si->isValid(askew.get())) << "the hole lets nothing through askew";
    askew->rotation().setIdentity();
    askew->setXYZ(0.0, 0.06, 0.0);
    EXPECT_FALSE(si->isValid(askew.get()));
}
}  // namespace
}  // namespace specplan::make_meshes
