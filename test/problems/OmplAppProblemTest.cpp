// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/OmplAppProblem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "Replaced.h"
#include "TemporaryFolder.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace
{
using test::complaintOf;
using test::replaced;
using test::TemporaryFolder;

const std::string kPlanar =
    "[problem]\n"                 // 1
    "name = Two rooms\n"          // 2
    "robot = robot.obj\n"         // 3
    "world=world.obj  # walls\n"  // 4
    "start.x = 1\n"               // 5
    "start.y = 2.5\n"             // 6
    "start.theta = 0.5\n"         // 7
    "goal.x = 8\n"                // 8
    "goal.y = -2e0\n"             // 9
    "goal.theta = 0\n"            // 10
    "volume.min.x = 0\n"          // 11
    "volume.min.y = -5\n"         // 12
    "volume.max.x = 10\n"         // 13
    "volume.max.y = 5\n"          // 14
    "\n"                          // 15
    "[benchmark]\n"               // 16
    "time_limit=20.0\n"           // 17
    "mem_limit=1000\n"            // 18
    "run_count=30\n"              // 19
    "[planner]\n";                // 20

const std::string kSpatial =
    "[problem]\nrobot=robot.obj\nworld=world.obj\n"
    "start.x=1\nstart.y=2\nstart.z=3\nstart.theta=0\nstart.axis.x=1\nstart.axis.y=0\nstart.axis.z=0\n"
    "goal.x=4\ngoal.y=5\ngoal.z=6\ngoal.theta=1.5\ngoal.axis.x=0\ngoal.axis.y=0\ngoal.axis.z=2\n";

/// A folder with the file and what it names; the meshes are not looked into here.
class OmplAppFile : public testing::Test
{
protected:
    OmplAppFile()
    {
        static_cast<void>(folder_.write("robot.obj", ""));
        static_cast<void>(folder_.write("world.obj", ""));
    }

    [[nodiscard]] OmplAppProblem read(const std::string& text) const
    {
        return readOmplAppProblem(folder_.write("a.cfg", text));
    }

    /// What is wrong with a text, without the folder.
    [[nodiscard]] std::string complaint(const std::string& text) const
    {
        std::string said = complaintOf<InputError>([&] { static_cast<void>(read(text)); });
        const std::string path = folder_ / "";
        return said.starts_with(path) ? said.substr(path.size()) : said;
    }

    TemporaryFolder folder_;
};

TEST_F(OmplAppFile, ReadsAProblemInThePlane)
{
    const OmplAppProblem problem = read(kPlanar);
    EXPECT_EQ(problem.name, "Two rooms");
    EXPECT_EQ(problem.robot.path, folder_ / "robot.obj");
    EXPECT_EQ(problem.world.line, 4U);
    EXPECT_TRUE(problem.planar);
    EXPECT_EQ(problem.start.position, (std::array{1.0, 2.5, 0.0}));
    EXPECT_EQ(problem.start.angle, 0.5);
    EXPECT_EQ(problem.goal.position, (std::array{8.0, -2.0, 0.0}));
    EXPECT_EQ(problem.goalThreshold, 1e-6);
    ASSERT_TRUE(problem.volume);
    EXPECT_EQ(problem.volume->low[1], -5.0);
    EXPECT_EQ(problem.volume->high[0], 10.0);
    EXPECT_EQ(problem.timeLimit, 20.0);
    EXPECT_EQ(problem.memoryLimit, 1000.0);
    EXPECT_EQ(problem.runCount, 30U);
    EXPECT_TRUE(problem.planners.empty());
    EXPECT_TRUE(problem.warnings.empty());
}

TEST_F(OmplAppFile, ReadsAProblemInSpace)
{
    const OmplAppProblem problem = read(kSpatial +
                                        "objective = max_min_clearance\nobjective.threshold=0.5\n"
                                        "threshold=0.25\nlongest_valid_segment_fraction=0.002\n");
    EXPECT_EQ(problem.name, "a") << "that of the file";
    EXPECT_FALSE(problem.planar);
    EXPECT_EQ(problem.start.position, (std::array{1.0, 2.0, 3.0}));
    EXPECT_EQ(problem.goal.axis, (std::array{0.0, 0.0, 2.0}));
    EXPECT_EQ(problem.goal.angle, 1.5);
    EXPECT_FALSE(problem.volume);
    EXPECT_EQ(problem.objective, RigidObjective::MaxMinClearance);
    EXPECT_EQ(problem.objectiveThreshold, 0.5);
    EXPECT_EQ(problem.goalThreshold, 0.25);
    EXPECT_EQ(problem.longestValidSegmentFraction, 0.002);
    EXPECT_TRUE(problem.warnings.empty());
}

TEST_F(OmplAppFile, ReadsPlannersWithTheirParameters)
{
    const OmplAppProblem problem = read(kPlanar +
                                        "rrtconnect.range=50\nrrtconnect=\nRRTConnect.range=100\nkpiece=\n"
                                        "rrtconnect.name=wide\nSpeculativeAStar.weight=2\n");
    ASSERT_EQ(problem.planners.size(), 4U);
    EXPECT_EQ(problem.planners[0].name, "rrtconnect");
    EXPECT_EQ(problem.planners[0].parameters.at("range"), "50");
    EXPECT_EQ(problem.planners[1].parameters.at("range"), "100") << "the last one of that name";
    EXPECT_EQ(problem.planners[1].parameters.at("name"), "wide");
    EXPECT_EQ(problem.planners[2].name, "kpiece");
    EXPECT_EQ(problem.planners[3].parameters.at("weight"), "2");
    EXPECT_TRUE(problem.warnings.empty());
}

TEST_F(OmplAppFile, ReportsWhatItDoesNotHeed)
{
    const OmplAppProblem problem = read(kPlanar +
                                        "rrt=\nteleport=\nteleport.range=3\nproblem.sampler=gaussian\n"
                                        "[colours]\nsky=blue\n[problem]\nstart.colour=red\n");
    std::vector<std::string> said;
    for (const std::string& warning : problem.warnings)
    {
        EXPECT_TRUE(warning.starts_with(folder_ / "a.cfg:")) << warning;
        said.push_back(warning.substr(std::string(folder_ / "a.cfg:").size()));
    }
    std::ranges::sort(said);
    EXPECT_EQ(said, (std::vector<std::string>{"22: planner 'teleport' is not known and left out",
                                              "23: planner 'teleport' is not known and left out",
                                              "24: planner.problem.sampler is not known and not heeded",
                                              "26: section [colours] is not known: sky is not heeded",
                                              "28: problem.start.colour is not known and not heeded"}));
    EXPECT_EQ(problem.planners.size(), 1U);
}

TEST_F(OmplAppFile, RefusesWhatIsWrongInOneLine)
{
    struct Bad
    {
        std::string text;
        std::string complaint;
    };
    const std::vector<Bad> bad{
        {"", "a.cfg: expected problem.robot, a mesh file, found none"},
        {replaced(kPlanar, "start.x = 1\n", ""), "a.cfg: expected problem.start.x, a number, found none"},
        {replaced(kPlanar, "start.theta = 0.5\n", ""),
         "a.cfg: expected problem.start.theta, an angle in radians, found none"},
        {replaced(kPlanar, "start.y = 2.5", "start.y = two"),
         "a.cfg:6: problem.start.y: expected a number, found 'two'"},
        {replaced(kPlanar, "goal.y = -2e0", "goal.y = nan"), "a.cfg:9: problem.goal.y: expected a number, found 'nan'"},
        {replaced(kPlanar, "goal.y = -2e0", "goal.y = 1,5"), "a.cfg:9: problem.goal.y: expected a number, found '1,5'"},
        {replaced(kPlanar, "start.theta = 0.5", "start.theta ="),
         "a.cfg:7: problem.start.theta: expected a number, found ''"},
        {replaced(kPlanar, "robot.obj", "none.obj"),
         "a.cfg:3: problem.robot: expected a mesh file relative to the folder of this file, found 'none.obj'"},
        {replaced(kPlanar, "robot.obj", ""), "a.cfg:3: problem.robot: expected a mesh file, found ''"},
        {replaced(kPlanar, "volume.min.x = 0", "volume.min.x = 10"),
         "a.cfg:14: expected problem.volume.min.x below problem.volume.max.x, found 10 and 10"},
        {replaced(kPlanar, "volume.max.y = 5\n", ""),
         "a.cfg:13: expected all sides of the volume or none, but problem.volume.max.y is missing"},
        {replaced(kPlanar, "goal.x = 8", "goal.x = 8\ngoal.x = 9"),
         "a.cfg:9: expected problem.goal.x once, but line 8 has it too"},
        {replaced(kPlanar, "run_count=30", "run_count=0"),
         "a.cfg:19: benchmark.run_count: expected a whole number from 1, found '0'"},
        {replaced(kPlanar, "time_limit=20.0", "time_limit=-1"),
         "a.cfg:17: benchmark.time_limit: expected a number from 0.001 to 1e+09, found '-1'"},
        {replaced(kPlanar, "[problem]", "[problem"), "a.cfg:1: expected a section such as [problem], found '[problem'"},
        {replaced(kPlanar, "goal.x = 8", "goal.x"), "a.cfg:8: expected 'key = value' or a section, found 'goal.x'"},
        {replaced(kPlanar, "name = Two rooms", "control = kinematic_car"),
         "a.cfg:2: problem.control: problems with controls ('kinematic_car') are not supported; expected a rigid body "
         "that moves freely"},
        {replaced(kPlanar, "name = Two rooms", "objective = beauty"),
         "a.cfg:2: problem.objective: expected length, max_min_clearance or mechanical_work, found 'beauty'"},
        {replaced(kSpatial, "goal.axis.y=0\n", ""), "a.cfg: expected problem.goal.axis.y, a number, found none"},
        {replaced(kSpatial, "goal.axis.z=2", "goal.axis.z=0"),
         "a.cfg:13: problem.goal.axis: expected an axis longer than 0"},
        {replaced(kSpatial, "start.z=3\n", ""), "a.cfg: expected problem.start.z, a number, found none"}};
    for (const Bad& each : bad)
        EXPECT_EQ(complaint(each.text), each.complaint) << each.text;
}

TEST_F(OmplAppFile, NamesAFileThatIsNotThere)
{
    const std::string file = folder_ / "none.cfg";
    EXPECT_EQ(complaintOf<InputError>([&] { static_cast<void>(readOmplAppProblem(file)); }),
              file + ": cannot be read: no such file, or no permission");
}
}  // namespace
}  // namespace specplan::problems
