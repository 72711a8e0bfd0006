// SPDX-License-Identifier: BSD-3-Clause
// Worlds of voxels against worlds of boxes, and OctoMap's files with what can be wrong about them.
#include "specplan/problems/fcl/OctoMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include <octomap/ColorOcTree.h>
#include <octomap/octomap.h>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "EightThreads.h"
#include "RigidFixture.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/fcl/RigidBodyChecker.h"
#include "specplan/problems/fcl/RigidBodySetup.h"

namespace specplan::problems
{
namespace
{
namespace ob = ompl::base;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using test::boxMesh;
using test::randomPose;

octomap::point3d pointOf(const Vector3d& place)
{
    return {static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())};
}

Isometry3d at(double x, double y, double z)
{
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = Vector3d(x, y, z);
    return pose;
}

/// Sets the voxels whose centres are in a box.
void fill(octomap::OcTree& map, const Vector3d& low, const Vector3d& high, bool occupied = true)
{
    const double size = map.getResolution();
    for (double x = low.x() + 0.5 * size; x < high.x(); x += size)
        for (double y = low.y() + 0.5 * size; y < high.y(); y += size)
            for (double z = low.z() + 0.5 * size; z < high.z(); z += size)
                map.updateNode(pointOf({x, y, z}), occupied);
}

/// 2 x 2 x 2 with walls, a block of one large voxel, free space, and scattered voxels; voxels of 0.1.
octomap::OcTree clutteredMap()
{
    octomap::OcTree map(0.1);
    fill(map, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, false);
    fill(map, {-1.0, -1.0, -1.0}, {-0.9, 1.0, 1.0});
    fill(map, {-1.0, -1.0, -1.0}, {1.0, 1.0, -0.9});
    fill(map, {0.0, 0.0, 0.0}, {0.8, 0.8, 0.8});
    std::mt19937 dice(11);
    for (int i = 0; i < 60; ++i)
        map.updateNode(pointOf(randomPose(dice, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}).translation()), 4.0F);
    return map;
}

/// A box for each occupied leaf of the map as it is.
RigidBody boxesOf(const octomap::OcTree& map)
{
    RigidBody body;
    for (auto leaf = map.begin_leafs(), end = map.end_leafs(); leaf != end; ++leaf)
        if (map.isNodeOccupied(*leaf))
            body.addBox(Vector3d::Constant(leaf.getSize()), at(leaf.getX(), leaf.getY(), leaf.getZ()));
    return body;
}

Mesh trolleyMesh()
{
    Mesh mesh = boxMesh({-0.2, -0.05, -0.05}, {0.2, 0.05, 0.05});
    addBox(mesh, {-0.2, -0.05, 0.05}, {-0.15, 0.05, 0.25});
    return mesh;
}

std::vector<RigidBody> someRobots()
{
    return {RigidBody().addMesh(trolleyMesh()), RigidBody().addBox({0.3, 0.1, 0.2}), RigidBody().addSphere(0.12),
            RigidBody().addCylinder(0.05, 0.4).addCapsule(0.03, 0.3, at(0.2, 0.0, 0.0))};
}

TEST(OctoMap, CollidesWhereABoxForEachOccupiedVoxelDoes)
{
    const octomap::OcTree map = clutteredMap();
    const RigidBody boxes = boxesOf(map);
    const std::vector<RigidBody> robots = someRobots();
    for (std::size_t kind = 0; kind < robots.size(); ++kind)
    {
        const RigidBodyScene voxelScene({robots[kind]}, RigidBody().addOctoMap(map));
        const RigidBodyScene boxScene({robots[kind]}, boxes);
        std::mt19937 dice(static_cast<unsigned>(kind) + 1);
        int hits = 0;
        for (int i = 0; i < 2000; ++i)
        {
            const std::array poses{randomPose(dice, {-1.3, -1.3, -1.3}, {1.3, 1.3, 1.3})};
            const bool expected = boxScene.collides(poses);
            hits += expected ? 1 : 0;
            ASSERT_EQ(voxelScene.collides(poses), expected) << "robot " << kind << ", pose " << i;
        }
        EXPECT_GT(hits, 300);
        EXPECT_LT(hits, 1700);
    }
}

TEST(OctoMap, IsAsFarAwayAsTheNearestOfItsBoxes)
{
    const octomap::OcTree map = clutteredMap();
    const RigidBody boxes = boxesOf(map);
    for (const RigidBody& robot : {RigidBody().addSphere(0.05), RigidBody().addBox({0.3, 0.1, 0.2})})
    {
        const RigidBodyScene voxelScene({robot}, RigidBody().addOctoMap(map));
        const RigidBodyScene boxScene({robot}, boxes);
        std::mt19937 dice(21);
        for (int i = 0; i < 200; ++i)
        {
            const std::array poses{randomPose(dice, {-1.3, -1.3, -1.3}, {1.3, 1.3, 1.3})};
            EXPECT_NEAR(voxelScene.distance(poses), boxScene.distance(poses), 2e-3) << "pose " << i;
        }
    }
}

TEST(OctoMap, MeshesAreAsFarAwayFromItAsFromBoxes)
{
    octomap::OcTree map(0.1);
    map.updateNode(pointOf({0.05, 0.05, 0.05}), true);
    const RigidBodyScene scene({RigidBody().addMesh(boxMesh({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}))},
                               RigidBody().addOctoMap(map));
    EXPECT_NEAR(scene.distance(std::array{at(0.5, 0.05, 0.05)}), 0.3, 1e-6);
    EXPECT_NEAR(scene.distance(std::array{at(-0.4, -0.5, 0.05)}), 0.5, 1e-6);
    EXPECT_EQ(scene.distance(std::array{at(0.15, 0.05, 0.05)}), 0.0);
}

TEST(OctoMap, HoldsARobotThatIsWhollyInsideOfIt)
{
    octomap::OcTree map(0.1);
    fill(map, {0.0, 0.0, 0.0}, {1.6, 1.6, 1.6});
    ASSERT_LT(map.getNumLeafNodes(), 100U) << "voxels of different sizes";
    for (const RigidBody& robot :
         {RigidBody().addMesh(boxMesh({-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02})),  // within a voxel of the finest
          RigidBody().addMesh(boxMesh({-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3})), RigidBody().addSphere(0.02)})
    {
        const RigidBodyScene scene({robot}, RigidBody().addOctoMap(map));
        for (const Isometry3d& pose : {at(0.45, 0.45, 0.45), at(0.75, 0.77, 0.79), at(1.05, 0.55, 0.95)})
        {
            EXPECT_TRUE(scene.collides({&pose, 1}));
            EXPECT_EQ(scene.distance({&pose, 1}), 0.0);
        }
        EXPECT_FALSE(scene.collides(std::array{at(2.0, 0.8, 0.8)}));
    }
}

TEST(OctoMap, OnlyOccupiedVoxelsCount)
{
    octomap::OcTree map(0.1);
    fill(map, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, false);
    map.updateNode(pointOf({0.95, 0.95, 0.95}), 4.0F);
    const RigidBodyScene scene({RigidBody().addSphere(0.3)}, RigidBody().addOctoMap(map));
    EXPECT_FALSE(scene.collides(std::array{at(0.0, 0.0, 0.0)})) << "free";
    EXPECT_FALSE(scene.collides(std::array{at(5.0, 0.0, 0.0)})) << "unknown";
    EXPECT_TRUE(scene.collides(std::array{at(0.95, 0.95, 1.2)}));
    EXPECT_TRUE(boundsOf(map).isApprox(Eigen::AlignedBox3d(Vector3d::Constant(-1.0), Vector3d::Constant(1.0)), 1e-6));
}

/// FCL takes a node below even odds for free, whatever the map says, and passes by inner nodes that are not up to date.
TEST(OctoMap, HeedsTheMapsThresholdAndLazyUpdates)
{
    for (const double threshold : {0.2, 0.5, 0.9})
        for (const bool lazy : {false, true})
        {
            octomap::OcTree map(0.1);
            map.setOccupancyThres(threshold);
            const float level = map.getOccupancyThresLog();
            fill(map, {-0.8, -0.8, -0.8}, {0.0, 0.0, 0.0}, false);
            map.setNodeValue(pointOf({-0.35, -0.35, -0.35}), level, lazy);
            map.setNodeValue(pointOf({0.35, 0.35, 0.35}), level - 0.1F, lazy);
            const RigidBodyScene scene({RigidBody().addMesh(boxMesh({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}))},
                                       RigidBody().addOctoMap(map));
            EXPECT_TRUE(scene.collides(std::array{at(-0.3, -0.3, -0.3)})) << threshold << ' ' << lazy;
            EXPECT_FALSE(scene.collides(std::array{at(0.3, 0.3, 0.3)})) << threshold << ' ' << lazy;
        }
}

TEST(OctoMap, MayGoOnChangingAfterItWasGiven)
{
    octomap::OcTree map(0.1);
    map.updateNode(pointOf({0.05, 0.05, 0.05}), true);
    const RigidBodyScene scene({RigidBody().addSphere(0.2)}, RigidBody().addOctoMap(map));
    map.updateNode(pointOf({2.05, 0.05, 0.05}), true);
    map.updateNode(pointOf({0.05, 0.05, 0.05}), -9.0F);
    EXPECT_TRUE(scene.collides(std::array{at(0.0, 0.0, 0.0)}));
    EXPECT_FALSE(scene.collides(std::array{at(2.0, 0.0, 0.0)}));
}

TEST(OctoMap, MovesWithItsBody)
{
    octomap::OcTree map(0.1);
    fill(map, {0.0, 0.0, 0.0}, {0.4, 0.1, 0.1});
    const RigidBody carried = RigidBody().addOctoMap(map, at(1.0, 0.0, 0.0));
    const RigidBodyScene scene({carried}, RigidBody().addOctoMap(map).addSphere(0.1, at(0.0, 0.0, 5.0)));
    EXPECT_TRUE(scene.collides(std::array{at(-0.7, 0.0, 0.0)}));
    EXPECT_FALSE(scene.collides(std::array{at(-0.5, 0.0, 0.0)}));
    EXPECT_NEAR(scene.distance(std::array{at(-0.5, 0.0, 0.0)}), 0.1, 1e-6);
    EXPECT_TRUE(scene.collides(std::array{at(-1.2, 0.0, 5.0)})) << "the ball";
}

TEST(OctoMap, HasASurfaceOfRectangles)
{
    octomap::OcTree map(0.5);
    fill(map, {0.0, 0.0, 0.0}, {2.0, 1.0, 0.5});
    EXPECT_EQ(surfaceOf(map).triangles.size(), 12U) << "one box";
    map.updateNode(pointOf({0.25, 0.25, 0.75}), true);
    const Mesh surface = surfaceOf(map);
    EXPECT_TRUE(boundsOf(surface).isApprox(Eigen::AlignedBox3d(Vector3d(0, 0, 0), Vector3d(2, 1, 1)), 1e-9));
    double volume = 0.0;
    for (const auto& t : surface.triangles)
        volume += surface.vertices[t[0]].dot(surface.vertices[t[1]].cross(surface.vertices[t[2]])) / 6.0;
    EXPECT_NEAR(volume, 1.0 + 0.125, 1e-9) << "closed and facing outward";
}

/// Two voxels that fill an eighth of all keys each: 32768 voxels of the finest along each edge.
TEST(OctoMap, HasASurfaceWhereVoxelsAreHuge)
{
    const test::TemporaryFolder folder;
    const auto map = readOctoMap(folder.write(
        "huge.bt", "# Octomap OcTree binary file\nid OcTree\nsize 3\nres 0.5\ndata\n" + std::string("\x0A\0", 2)));
    EXPECT_EQ(occupiedBoxes(*map).size(), 2U);
    EXPECT_EQ(surfaceOf(*map).triangles.size(), 20U) << "all sides but the two that meet";
    const RigidBodyScene scene({RigidBody().addSphere(1.0)}, RigidBody().addOctoMap(*map));
    EXPECT_TRUE(scene.collides(std::array{at(-100.0, -100.0, -100.0)}));
    EXPECT_NEAR(scene.distance(std::array{at(-100.0, -100.0, 4.0)}), 3.0, 1e-3);
}

TEST(OctoMap, ReadsWhatItWrites)
{
    const test::TemporaryFolder folder;
    const octomap::OcTree map = clutteredMap();
    writeOctoMap(folder / "a.bt", map);
    map.write(folder / "a.ot");
    for (const char* name : {"a.bt", "a.ot"})
    {
        const auto read = readOctoMap(folder / name);
        EXPECT_EQ(read->getResolution(), 0.1);
        EXPECT_TRUE(boundsOf(*read).isApprox(boundsOf(map), 1e-6)) << name;
        EXPECT_EQ(surfaceOf(*read).triangles, surfaceOf(map).triangles) << name;
    }
}

TEST(OctoMap, RefusesBadFilesInOneLine)
{
    const test::TemporaryFolder folder;
    const octomap::OcTree map = clutteredMap();
    writeOctoMap(folder / "good.bt", map);
    map.write(folder / "good.ot");
    const std::string binary = folder.read("good.bt");
    const std::string full = folder.read("good.ot");
    writeOctoMap(folder / "empty.bt", octomap::OcTree(0.1));
    octomap::OcTree(0.1).write(folder / "empty.ot");
    octomap::OcTree free(0.1);
    fill(free, {0.0, 0.0, 0.0}, {0.5, 0.5, 0.5}, false);
    writeOctoMap(folder / "free.bt", free);
    octomap::ColorOcTree coloured(0.1);
    coloured.updateNode(pointOf({0.0, 0.0, 0.0}), true);
    coloured.write(folder / "coloured.ot");
    const auto header = [](const std::string& text) { return text.substr(0, text.find("data\n") + 5); };
    const auto replaced = [](std::string text, const std::string& what, const std::string& by)
    { return text.replace(text.find(what), what.size(), by); };
    struct Bad
    {
        std::string file;
        std::string complaint;
    };
    const std::vector<Bad> bad{
        {folder / "none.bt", "expected an OctoMap file (.bt, .ot), found none"},
        {folder / ".", "expected an OctoMap file (.bt, .ot), found none"},
        {folder.write("nothing.bt", ""), "expected an OctoMap file (.bt, .ot), which begins with"},
        {folder.write("text.bt", "hello\nworld\n"), "expected an OctoMap file (.bt, .ot), which begins with"},
        {folder.write("head.bt", binary.substr(0, 40)), "expected an OctoMap file (.bt, .ot), found no whole header"},
        {folder.write("header.bt", header(binary)), "expected a whole OctoMap, but the file ends after 1 nodes"},
        {folder.write("half.bt", binary.substr(0, binary.size() / 2)), "expected a whole OctoMap, but the file ends"},
        {folder.write("most.bt", binary.substr(0, binary.size() - 1)), "expected a whole OctoMap, but the file ends"},
        {folder.write("half.ot", full.substr(0, full.size() / 2)), "expected a whole OctoMap, but the file ends"},
        {folder.write("deep.bt", header(binary) + std::string(100000, '\xFF')),
         "expected an OctoMap, but voxels lie more than 16 levels deep"},
        {folder.write("deep.ot", header(full) + std::string(100000, '\xFF')),
         "expected an OctoMap, but voxels lie more than 16 levels deep"},
        {folder.write("count.bt", replaced(binary, "size ", "size 1")), "expected an OctoMap of 1"},
        {folder.write("size.bt", replaced(binary, "size ", "size -")), "expected a number of nodes as 'size', found"},
        {folder.write("flat.bt", replaced(binary, "res 0.1", "res 0")), "expected voxels larger than 0"},
        {folder.write("nan.bt", replaced(binary, "res 0.1", "res nan")), "expected a number as 'res', found 'nan'"},
        {folder / "empty.bt", "expected a map with occupied voxels, found an empty one"},
        {folder / "empty.ot", "expected a map with occupied voxels, found an empty one"},
        {folder / "free.bt", "expected a map with occupied voxels, found free ones only"},
        {folder / "coloured.ot", "expected a map of class OcTree, found 'ColorOcTree'"}};
    for (const Bad& each : bad)
    {
        testing::internal::CaptureStderr();
        const std::string said = test::complaintOf<InputError>([&] { static_cast<void>(readOctoMap(each.file)); });
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "OctoMap itself, about " << each.file;
        EXPECT_EQ(said.rfind(each.file + ": " + each.complaint, 0), 0U) << each.file << " said: " << said;
        EXPECT_EQ(std::ranges::count(said, '\n'), 0) << said;
    }
}

/// No byte that is wrong leads to more than a complaint.
TEST(OctoMap, SurvivesDamagedFiles)
{
    const test::TemporaryFolder folder;
    const octomap::OcTree map = clutteredMap();
    writeOctoMap(folder / "good.bt", map);
    map.write(folder / "good.ot");
    std::mt19937 dice(31);
    for (const char* name : {"good.bt", "good.ot"})
    {
        const std::string good = folder.read(name);
        for (int i = 0; i < 300; ++i)
        {
            std::string damaged = good;
            damaged[dice() % damaged.size()] = static_cast<char>(dice());
            const std::string file = folder.write("damaged", damaged);
            testing::internal::CaptureStderr();
            try
            {
                static_cast<void>(readOctoMap(file));
            }
            catch (const InputError&)
            {
            }
            EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
        }
    }
}

TEST(OctoMap, NothingOccupiedIsNoBody)
{
    EXPECT_THROW(RigidBody().addOctoMap(octomap::OcTree(0.1)), std::invalid_argument);
    octomap::OcTree free(0.1);
    fill(free, {0.0, 0.0, 0.0}, {0.5, 0.5, 0.5}, false);
    EXPECT_THROW(RigidBody().addOctoMap(free), std::invalid_argument);
}

/// Eight threads ask one checker the same questions in different orders; all begin with the first distance, which makes
/// the surface.
TEST(OctoMapThreads, EightThreadsGetTheAnswersOfOne)
{
    auto space = std::make_shared<ob::SE3StateSpace>();
    ob::RealVectorBounds bounds(3);
    bounds.setLow(-1.3);
    bounds.setHigh(1.3);
    space->setBounds(bounds);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    const octomap::OcTree map = clutteredMap();
    const auto scene = [&map]
    {
        return std::make_shared<const RigidBodyScene>(std::vector{RigidBody().addMesh(trolleyMesh())},
                                                      RigidBody().addOctoMap(map));
    };
    test::expectOneThreadsAnswers(si, RigidBodyChecker(si, scene()), RigidBodyChecker(si, scene()), 240, 40);
}

/// The room of the other tests as voxels of 0.2.
class VoxelRoom : public testing::Test
{
protected:
    VoxelRoom()
    {
        octomap::OcTree map(0.2);
        fill(map, {0.0, 0.0, 0.0}, {10.0, 10.0, 3.2}, false);
        for (const auto& [low, high] :
             std::vector<std::pair<Vector3d, Vector3d>>{{{-0.2, -0.2, 0.0}, {0.0, 10.2, 3.0}},
                                                        {{10.0, -0.2, 0.0}, {10.2, 10.2, 3.0}},
                                                        {{0.0, -0.2, 0.0}, {10.0, 0.0, 3.0}},
                                                        {{0.0, 10.0, 0.0}, {10.0, 10.2, 3.0}},
                                                        {{4.8, 2.0, 0.0}, {5.2, 10.0, 3.0}}})
            for (double x = low.x() + 0.1; x < high.x(); x += 0.2)
                for (double y = low.y() + 0.1; y < high.y(); y += 0.2)
                    for (double z = low.z() + 0.1; z < high.z(); z += 0.2)
                        map.updateNode(pointOf({x, y, z}), 4.0F);
        writeOctoMap(room_.folder / "room.bt", map);
    }

    [[nodiscard]] RigidBodySetup read(std::string text) const
    {
        const std::size_t at = text.find("room.obj");
        return RigidBodySetup(readOmplAppProblem(room_.folder.write("a.cfg", text.replace(at, 8, "room.bt"))));
    }

    test::RoomFolder room_;
};

TEST_F(VoxelRoom, IsAWorldForProblemFiles)
{
    const RigidBodySetup spatial = read(test::RoomFolder::spatial());
    EXPECT_NEAR(spatial.bounds().low[0], -0.2, 1e-5);
    EXPECT_NEAR(spatial.bounds().high[1], 10.2, 1e-5);
    EXPECT_NEAR(spatial.bounds().high[2], 3.2, 1e-5) << "free voxels are known too";
    EXPECT_FALSE(spatial.world().triangles.empty());
    const auto setup = read(test::RoomFolder::planar()).makeSetup();
    setup->getSpaceInformation()->setup();
    EXPECT_TRUE(setup->getSpaceInformation()->isValid(setup->getProblemDefinition()->getStartState(0)));
}

TEST_F(VoxelRoom, RefusesAStartInAVoxel)
{
    std::string text = test::RoomFolder::planar();
    text.replace(text.find("start.x = 2"), 11, "start.x = 5");
    EXPECT_EQ(test::complaintOf<InputError>([&] { static_cast<void>(read(text)); }),
              room_.folder / "a.cfg" + ":6: expected a free start, but there the robot collides with the world");
}
}  // namespace
}  // namespace specplan::problems
