// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/MeshFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "Replaced.h"
#include "RigidFixture.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace
{
using test::boxMesh;
using test::complaintOf;
using test::TemporaryFolder;

/// A binary STL file of one triangle with such a first coordinate.
std::string stlWith(float x)
{
    std::string text(80, ' ');
    const auto append = [&text](auto value)
    {
        const auto bytes = std::bit_cast<std::array<char, sizeof value>>(value);
        text.append(bytes.begin(), bytes.end());
    };
    append(std::uint32_t{1});
    for (const float value : {0.0F, 0.0F, 1.0F, x, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F})
        append(value);
    append(std::uint16_t{0});
    return text;
}

/// One triangle (0, 0, 0), (1, 0, 0), (0, 2, 0) below such a matrix.
std::string collada(const std::string& up, const std::string& matrix)
{
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>)" +
           up + R"(</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 2 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries>
<library_visual_scenes><visual_scene id="s"><node><matrix>)" +
           matrix + R"(</matrix><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST(Mesh, FallsIntoPartsThatShareNoCorner)
{
    Mesh mesh = boxMesh({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
    addBox(mesh, {1.0, 1.0, 1.0}, {2.0, 2.0, 2.0});  // one corner in common
    addBox(mesh, {5.0, 0.0, 0.0}, {6.0, 1.0, 1.0});
    const std::vector<Mesh> parts = connectedParts(mesh);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].triangles.size(), 24U);
    EXPECT_TRUE(boundsOf(parts[1]).isApprox(Eigen::AlignedBox3d(Eigen::Vector3d(5, 0, 0), Eigen::Vector3d(6, 1, 1))));
}

TEST(ReadMesh, ReadsWhatWriteObjWrites)
{
    const TemporaryFolder folder;
    writeObj(folder / "box.obj", boxMesh({1.0, 2.0, 3.0}, {2.0, 4.0, 6.0}));
    const Mesh mesh = readMesh(folder / "box.obj");
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_TRUE(boundsOf(mesh).isApprox(Eigen::AlignedBox3d(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(2, 4, 6))));
    EXPECT_TRUE(centreOf(mesh).isApprox(Eigen::Vector3d(1.5, 3.0, 4.5), 1e-6));
}

TEST(ReadMesh, HeedsTheTransformsOfACollada)
{
    const TemporaryFolder folder;
    const std::string matrix = "10 0 0 5  0 10 0 0  0 0 10 -1  0 0 0 1";
    const auto bounds = [&](const std::string& up)
    { return boundsOf(readMesh(folder.write("a.dae", collada(up, matrix)))); };
    EXPECT_TRUE(bounds("Y_UP").isApprox(Eigen::AlignedBox3d(Eigen::Vector3d(5, 0, -1), Eigen::Vector3d(15, 20, -1))));
    // Assimp turns z to y, and OMPL.app's meshes are made for that.
    EXPECT_TRUE(bounds("Z_UP").isApprox(Eigen::AlignedBox3d(Eigen::Vector3d(5, -1, -20), Eigen::Vector3d(15, -1, 0))));
}

TEST(ReadMesh, ReadsStl)
{
    const TemporaryFolder folder;
    EXPECT_EQ(readMesh(folder.write("a.stl", stlWith(-2.0F))).triangles.size(), 1U);
}

/// What crashes Assimp 5.2, or keeps it busy for ever.
TEST(ReadMesh, LooksOverCollada)
{
    const TemporaryFolder folder;
    const std::string good = collada("Y_UP", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
    const auto complaint = [&](const std::string& what, const std::string& by)
    {
        const std::string file = folder.write("a.dae", test::replaced(good, what, by));
        return complaintOf<InputError>([&] { static_cast<void>(readMesh(file)); }).substr(file.size());
    };
    EXPECT_EQ(complaint("count=\"9\"", "count=\"0\""),
              ":5: expected a mesh, but an accessor reaches to number 9 of an array of 0");
    EXPECT_EQ(complaint("count=\"9\"", "count=\"x\""), ":4: expected a mesh, but its count is 'x', not a whole number");
    EXPECT_EQ(complaint("count=\"3\" stride", "count=\"4\" stride"),
              ":5: expected a mesh, but an accessor reaches to number 12 of an array of 9");
    EXPECT_EQ(complaint("stride=\"3\"", "stride=\"4000000000\""),
              ":5: expected a mesh, but an accessor reaches to number 12000000000 of an array of 9");
    EXPECT_EQ(complaint("<p>0 1 2", "<p>0 1x 2"), ":8: expected a mesh, but <p> has '1x' among its whole numbers");
    EXPECT_EQ(complaint("<p>0 1 2", "<p>0 1 \x02"), ":8: expected a mesh, but <p> has '\\x02' among its whole numbers");
    EXPECT_EQ(readMesh(folder.write("b.dae", test::replaced(good, "<p>", "<!-- <p>x</p> --><p>"))).triangles.size(),
              1U);
}

TEST(ReadMesh, RefusesBadFilesInOneLine)
{
    const TemporaryFolder folder;
    struct Bad
    {
        std::string file;
        std::string complaint;
    };
    const std::vector<Bad> bad{
        {folder / "none.obj", "expected a mesh file, found none"},
        {folder / ".", "expected a mesh file, found none"},
        {folder.write("empty.obj", ""), "expected a mesh (COLLADA, STL, OBJ)"},
        {folder.write("empty.dae", ""), "expected a mesh (COLLADA, STL, OBJ)"},
        {folder.write("text.dae", "hello"), "expected a mesh (COLLADA, STL, OBJ)"},
        {folder.write("half.dae", collada("Y_UP", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1").substr(0, 500)),
         "expected a mesh"},
        {folder.write("a.xyz", "v 0 0 0"), "expected a mesh (COLLADA, STL, OBJ)"},
        {folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "expected a mesh"},
        {folder.write("lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\n"),
         "expected a mesh of triangles, found none"},
        {folder.write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), "expected a mesh"},
        {folder.write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "expected finite coordinates"},
        {folder.write("nan.stl", stlWith(std::numeric_limits<float>::quiet_NaN())), "expected finite coordinates"},
        {folder.write("inf.stl", stlWith(std::numeric_limits<float>::infinity())), "expected finite coordinates"}};
    for (const Bad& each : bad)
    {
        const std::string said = complaintOf<InputError>([&] { static_cast<void>(readMesh(each.file)); });
        EXPECT_EQ(said.rfind(each.file + ": " + each.complaint, 0), 0U) << each.file << " said: " << said;
        EXPECT_EQ(std::ranges::count(said, '\n'), 0) << said;
    }
}
}  // namespace
}  // namespace specplan::problems
