// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/RigidBodySetup.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "RigidFixture.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/fcl/MeshFile.h"
#include "specplan/problems/fcl/RigidBodyChecker.h"

namespace specplan::problems
{
namespace
{
namespace ob = ompl::base;
using test::complaintOf;
using test::RoomFolder;

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

class RigidSetup : public testing::Test
{
protected:
    [[nodiscard]] RigidBodySetup read(const std::string& text) const
    {
        return RigidBodySetup(readOmplAppProblem(room_.folder.write("a.cfg", text)));
    }

    [[nodiscard]] std::string complaint(const std::string& text) const
    {
        std::string said = complaintOf<InputError>([&] { static_cast<void>(read(text)); });
        const std::string path = room_.folder / "";
        return said.starts_with(path) ? said.substr(path.size()) : said;
    }

    RoomFolder room_;
};

TEST_F(RigidSetup, MovesTheRobotToItsReferencePoint)
{
    const RigidBodySetup spatial = read(RoomFolder::spatial());
    EXPECT_TRUE(centreOf(spatial.robot()).isZero(1e-5));
    const RigidBodySetup planar = read(RoomFolder::planar());
    EXPECT_TRUE(centreOf(planar.robot()).isApprox(Eigen::Vector3d(0.0, 0.0, 1.5), 1e-5)) << "its height stays";
}

TEST_F(RigidSetup, TakesTheBoundsOfTheWorldWhereNoneAreGiven)
{
    const ob::RealVectorBounds bounds = read(RoomFolder::spatial()).bounds();
    ASSERT_EQ(bounds.low.size(), 3U);
    EXPECT_NEAR(bounds.low[0], -0.2, 1e-6);
    EXPECT_NEAR(bounds.high[1], 10.2, 1e-6);
    EXPECT_NEAR(bounds.high[2], 3.0, 1e-6);
    EXPECT_EQ(read(RoomFolder::planar()).bounds().low.size(), 2U);
}

TEST_F(RigidSetup, EnlargesTheVolumeToHoldStartAndGoal)
{
    const RigidBodySetup setup = read(replaced(RoomFolder::planar(), "[benchmark]",
                                               "volume.min.x=0\nvolume.min.y=0\nvolume.max.x=7\nvolume.max.y=9\n"
                                               "[benchmark]"));
    EXPECT_EQ(setup.bounds().high, (std::vector<double>{8.0, 9.0}));
    ASSERT_EQ(setup.warnings().size(), 1U);
    EXPECT_NE(setup.warnings()[0].find("a.cfg:9: x = 8 is outside of the volume"), std::string::npos)
        << setup.warnings()[0];
}

TEST_F(RigidSetup, RefusesProblemsThatCannotBeMeantInOneLine)
{
    struct Bad
    {
        std::string text;
        std::string complaint;
    };
    writeObj(room_.folder / "flat.obj", Mesh{{{0, 0, 5}, {10, 0, 5}, {0, 10, 5}}, {{0, 1, 2}}});
    static_cast<void>(room_.folder.write("broken.dae", "no mesh"));
    std::string flatWorld = replaced(RoomFolder::spatial(), "room.obj", "flat.obj");
    flatWorld = replaced(replaced(flatWorld, "start.z = 1.5", "start.z = 5"), "goal.z = 1.5", "goal.z = 5");
    const std::vector<Bad> bad{
        {replaced(RoomFolder::planar(), "start.x = 2", "start.x = 5"),
         "a.cfg:6: expected a free start, but there the robot collides with the world"},
        {replaced(RoomFolder::spatial(), "goal.x = 8", "goal.x = 10"),
         "a.cfg:14: expected a free goal, but there the robot collides with the world"},
        {flatWorld, "a.cfg: expected problem.volume.min.z and problem.volume.max.z: the world is flat along z"},
        {replaced(RoomFolder::planar(), "room.obj", "broken.dae"), "broken.dae: expected a mesh"}};
    for (const Bad& each : bad)
        EXPECT_EQ(complaint(each.text).substr(0, each.complaint.size()), each.complaint) << each.text;
}

TEST_F(RigidSetup, ARobotLargerThanTheWorldIsAWarning)
{
    writeObj(room_.folder / "small.obj", test::boxMesh({4.9, 4.9, 0.0}, {5.1, 5.1, 0.2}));
    const RigidBodySetup problem = read(replaced(RoomFolder::planar(), "room.obj", "small.obj"));
    ASSERT_EQ(problem.warnings().size(), 1U);
    EXPECT_NE(problem.warnings().front().find("a.cfg:3: the robot, "), std::string::npos) << problem.warnings().front();
    EXPECT_NE(problem.warnings().front().find(" is larger than the world, 0.2 x 0.2 x 0.2; are both in the same unit?"),
              std::string::npos);
}

TEST_F(RigidSetup, ReadsMeshesAsItIsTold)
{
    std::vector<std::string> files;
    const RigidBodySetup problem(readOmplAppProblem(room_.folder.write("a.cfg", RoomFolder::planar())),
                                 [&files](const std::string& path)
                                 {
                                     files.push_back(path);
                                     return readMesh(path);
                                 });
    EXPECT_EQ(files, (std::vector<std::string>{room_.folder / "robot.obj", room_.folder / "room.obj"}));
}

TEST_F(RigidSetup, MakesSetupsThatOmplSolves)
{
    for (const std::string& text : {RoomFolder::planar(), RoomFolder::spatial()})
    {
        const RigidBodySetup problem = read(text);
        const auto setup = problem.makeSetup();
        setup->setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup->getSpaceInformation()));
        ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(setup->getSolutionPath().check());
        EXPECT_EQ(posesOf(*setup->getStateSpace(), setup->getSolutionPath().getState(0))[0].translation().head<2>(),
                  Eigen::Vector2d(2.0, 8.0));
    }
}

TEST_F(RigidSetup, HandsTheFilesWishesToOmpl)
{
    const auto setup = read(replaced(RoomFolder::planar(), "[benchmark]",
                                     "objective=max_min_clearance\nobjective.threshold=0.3\nthreshold=0.5\n"
                                     "longest_valid_segment_fraction=0.002\n[benchmark]"))
                           .makeSetup();
    EXPECT_EQ(setup->getStateSpace()->getLongestValidSegmentFraction(), 0.002);
    const auto objective = setup->getProblemDefinition()->getOptimizationObjective();
    EXPECT_NE(dynamic_cast<const ob::MaximizeMinClearanceObjective*>(objective.get()), nullptr);
    EXPECT_EQ(objective->getCostThreshold().value(), 0.3);
    EXPECT_EQ(setup->getGoal()->as<ob::GoalRegion>()->getThreshold(), 0.5);
}

TEST_F(RigidSetup, ChecksCanBeMadeToTakeLonger)
{
    const RigidBodySetup problem = read(RoomFolder::planar());
    const auto setup = problem.makeSetup({std::chrono::milliseconds(5), false});
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(setup->getSpaceInformation()->isValid(setup->getProblemDefinition()->getStartState(0)));
    EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(5)) << "sleeping is never shorter";
}

/// Published problems; the folder is not part of the project.
TEST(PublishedRigidBodies, LoadWithFreeStartAndGoal)
{
    const char* folder = std::getenv("SPECPLAN_DATA_DIR");
    if (folder == nullptr || *folder == '\0')
        GTEST_SKIP() << "SPECPLAN_DATA_DIR is not set";
    // Share of free states among random ones, measured with another program.
    const std::map<std::string, double> shares{
        {"Maze_planar", 0.35}, {"UniqueSolutionMaze", 0.46}, {"Easy", 0.60}, {"cubicles", 0.44}};
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(folder) + "/omplapp"))
    {
        if (entry.path().extension() != ".cfg")
            continue;
        ++files;
        const RigidBodySetup problem(readOmplAppProblem(entry.path().string()));
        EXPECT_TRUE(problem.warnings().empty()) << problem.warnings().front();
        const auto setup = problem.makeSetup();
        const auto& si = setup->getSpaceInformation();
        si->setup();
        EXPECT_TRUE(si->isValid(setup->getProblemDefinition()->getStartState(0))) << entry.path();
        EXPECT_TRUE(si->isValid(setup->getGoal()->as<ob::GoalState>()->getState())) << entry.path();
        const auto known = shares.find(entry.path().stem().string());
        if (known == shares.end())
            continue;
        const double share = si->probabilityOfValidState(10000);
        EXPECT_NEAR(share, known->second, 0.025) << entry.path();
    }
    EXPECT_GE(files, 4);
}
}  // namespace
}  // namespace specplan::problems
