// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/Mesh.h"

#include <algorithm>
#include <map>

#include "specplan/problems/InputError.h"

namespace specplan::problems
{
void requireSound(const Mesh& mesh, const std::string& file)
{
    if (mesh.triangles.empty())
        throw InputError(file, 0, "expected a mesh of triangles, found none");
    for (const auto& triangle : mesh.triangles)
        if (std::ranges::any_of(triangle, [&mesh](std::uint32_t corner) { return corner >= mesh.vertices.size(); }))
            throw InputError(file, 0, "expected triangles between the mesh's vertices, found another corner");
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (!mesh.vertices[i].allFinite())
            throw InputError(file, 0, concat("expected finite coordinates, but those of vertex ", i, " are not"));
}

Eigen::Vector3d centreOf(const Mesh& mesh)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        sum += vertex;
    return mesh.vertices.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(mesh.vertices.size()));
}

Eigen::AlignedBox3d boundsOf(const Mesh& mesh)
{
    Eigen::AlignedBox3d bounds;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            bounds.extend(mesh.vertices[corner]);
    return bounds;
}

Mesh moved(Mesh mesh, const Eigen::Vector3d& by)
{
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex += by;
    return mesh;
}

std::vector<Mesh> connectedParts(const Mesh& mesh)
{
    // Union of the corners of each triangle; a root stands for its part.
    std::map<std::array<double, 3>, std::uint32_t> places;
    std::vector<std::uint32_t> parent;
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
    {
        const Eigen::Vector3d& v = mesh.vertices[i];
        parent.push_back(places.emplace(std::array{v.x(), v.y(), v.z()}, i).first->second);
    }
    const auto root = [&parent](std::uint32_t i)
    {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            parent[root(corner)] = root(triangle[0]);

    std::vector<Mesh> parts;
    std::map<std::uint32_t, std::size_t> numbers;
    for (const auto& triangle : mesh.triangles)
    {
        const auto [found, isNew] = numbers.emplace(root(triangle[0]), parts.size());
        Mesh& part = isNew ? parts.emplace_back() : parts[found->second];
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        for (const std::uint32_t corner : triangle)
            part.vertices.push_back(mesh.vertices[corner]);
        part.triangles.push_back({first, first + 1, first + 2});
    }
    return parts;
}

void addBox(Mesh& mesh, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    // Corner i is high along the axes whose bits are set in i.
    for (unsigned i = 0; i < 8; ++i)
        mesh.vertices.emplace_back((i & 1U) != 0 ? high.x() : low.x(), (i & 2U) != 0 ? high.y() : low.y(),
                                   (i & 4U) != 0 ? high.z() : low.z());
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& side : kSides)
    {
        mesh.triangles.push_back({first + side[0], first + side[1], first + side[2]});
        mesh.triangles.push_back({first + side[0], first + side[2], first + side[3]});
    }
}
}  // namespace specplan::problems
