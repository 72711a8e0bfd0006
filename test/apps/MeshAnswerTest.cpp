// SPDX-License-Identifier: BSD-3-Clause
// What the process that reads a mesh may answer.
#include "MeshAnswer.h"

#include <gtest/gtest.h>

#include <csignal>
#include <limits>

#include "TemporaryFolder.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
namespace
{
using problems::InputError;
using problems::Mesh;

constexpr ReaderLimits kLimits{10, std::uint64_t{1424} << 20U};
/// As waitpid() has them.
constexpr int kGoodEnd = 0;
constexpr int kExitOne = 1 << 8;

Mesh triangle()
{
    return {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 2.0, -0.5}}, {{0, 1, 2}}};
}

std::string answerWith(const Mesh& mesh)
{
    std::string answer;
    sendMesh(mesh,
             [&answer](const void* data, std::size_t size) { answer.append(static_cast<const char*>(data), size); });
    return answer;
}

std::string complaint(const std::string& answer, int status = kGoodEnd)
{
    return test::complaintOf<InputError>([&] { static_cast<void>(meshOf("a.dae", answer, status, kLimits)); });
}

TEST(MeshAnswer, IsTheMesh)
{
    const Mesh mesh = meshOf("a.dae", answerWith(triangle()), kGoodEnd, kLimits);
    EXPECT_EQ(mesh.vertices, triangle().vertices);
    EXPECT_EQ(mesh.triangles, triangle().triangles);
}

TEST(MeshAnswer, IsTheReasonWhyThereIsNone)
{
    std::string answer;
    sendRefusal("a.dae:3: expected sense",
                [&answer](const void* data, std::size_t size) { answer.append(static_cast<const char*>(data), size); });
    EXPECT_EQ(complaint(answer), "a.dae:3: expected sense");
}

TEST(MeshAnswer, HasToBeWhole)
{
    const std::string part =
        "a.dae: expected a mesh (COLLADA, STL, OBJ), but its reader (Assimp) handed over only part";
    const std::string whole = answerWith(triangle());
    for (std::size_t size = 1; size < whole.size(); ++size)
        EXPECT_EQ(complaint(whole.substr(0, size)), part + " of it") << size;
    EXPECT_EQ(complaint(whole + 'x'), part + " of it");
    EXPECT_EQ(complaint('x' + whole.substr(1)), part + " of it");
    EXPECT_EQ(complaint("r"), part + " of it") << "a refusal without a reason";
    EXPECT_EQ(complaint("m" + std::string(8, '\xFF') + whole.substr(9)), part + " of it") << "2^64 - 1 vertices";
}

TEST(MeshAnswer, HasToBeAMesh)
{
    Mesh far = triangle();
    far.triangles[0][2] = 3;
    EXPECT_EQ(complaint(answerWith(far)),
              "a.dae: expected triangles between the mesh's vertices, found another corner");
    Mesh endless = triangle();
    endless.vertices[1].y() = std::numeric_limits<double>::infinity();
    EXPECT_EQ(complaint(answerWith(endless)), "a.dae: expected finite coordinates, but those of vertex 1 are not");
    EXPECT_EQ(complaint(answerWith({triangle().vertices, {}})), "a.dae: expected a mesh of triangles, found none");
}

TEST(MeshAnswer, EndsWithItsProcess)
{
    const std::string reader = "a.dae: expected a mesh (COLLADA, STL, OBJ), but its reader (Assimp) ";
    for (const std::string& said : {std::string(), answerWith(triangle())})
    {
        EXPECT_EQ(complaint(said, SIGXCPU), reader + "was still at it after 10 s; is it damaged?");
        EXPECT_EQ(complaint(said, SIGSEGV), reader + "crashed (signal 11); is it damaged?");
        EXPECT_EQ(complaint(said, kExitOne), reader + "asked for more than 1424 MiB; is it damaged?");
    }
    EXPECT_EQ(complaint(""), reader + "asked for more than 1424 MiB; is it damaged?");
}
}  // namespace
}  // namespace specplan::command
