// SPDX-License-Identifier: BSD-3-Clause
// What the process that reads a mesh answers, where damage may have reached it: one byte of how it ended, then the
// answer.
#include <algorithm>

#include "FuzzInput.h"
#include "MeshAnswer.h"

namespace
{
using specplan::problems::Mesh;

void requireWhole(const Mesh& mesh, std::string_view answer)
{
    const auto isVertex = [&mesh](std::uint32_t corner) { return corner < mesh.vertices.size(); };
    for (const auto& triangle : mesh.triangles)
        if (!std::ranges::all_of(triangle, isVertex))
            specplan::fuzz::fail("a corner is no vertex", "");
    std::string again;
    specplan::command::sendMesh(mesh,
                                [&again](const void* bytes, std::size_t size)
                                {
                                    if (size > 0)
                                        again.append(static_cast<const char*>(bytes), size);
                                });
    if (again != answer)
        specplan::fuzz::fail("a mesh is not what was sent", "");
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const int status = data[0] < 128 ? data[0] : (data[0] - 128) << 8;  // ended by a signal, or with an exit status
    const std::string_view answer(reinterpret_cast<const char*>(data) + 1, size - 1);
    try
    {
        const Mesh mesh = specplan::command::meshOf("mesh.dae", answer, status, {10, std::uint64_t{1} << 30U});
        requireWhole(mesh, answer);
        if (status != 0)
            specplan::fuzz::fail("a mesh of a process that came to no good end", "");
    }
    catch (const specplan::problems::InputError& error)
    {
        specplan::fuzz::requireOneLine(error.what());
    }
    return 0;
}
