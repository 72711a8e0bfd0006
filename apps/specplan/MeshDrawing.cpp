// SPDX-License-Identifier: BSD-3-Clause
#include "MeshDrawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "Text.h"

namespace specplan::command
{
namespace
{
using problems::Mesh;

/// Number of the first vertex at each vertex' place.
std::vector<std::uint32_t> weld(const Mesh& mesh)
{
    std::map<std::array<double, 3>, std::uint32_t> places;
    std::vector<std::uint32_t> first;
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
    {
        const Eigen::Vector3d& v = mesh.vertices[i];
        first.push_back(places.emplace(std::array{v.x(), v.y(), v.z()}, i).first->second);
    }
    return first;
}

std::string number(double pixels)
{
    return fixed(std::abs(pixels) < 0.05 ? 0.0 : pixels, 1);
}

void append(std::string& path, char letter, const Eigen::Vector2d& point)
{
    path += letter;
    path += number(point.x()) + ' ' + number(point.y());
}
}  // namespace

std::vector<std::array<Eigen::Vector3d, 2>> featureEdges(const Mesh& mesh)
{
    constexpr double kFlat = 0.94;  // cosine of 20 degrees
    const std::vector<std::uint32_t> first = weld(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Eigen::Vector3d>> normals;
    for (const auto& triangle : mesh.triangles)
    {
        const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
        const Eigen::Vector3d normal =
            (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).normalized();
        for (std::size_t i = 0; i < 3; ++i)
        {
            const auto [low, high] = std::minmax(first[triangle[i]], first[triangle[(i + 1) % 3]]);
            normals[{low, high}].push_back(normal);
        }
    }
    std::vector<std::array<Eigen::Vector3d, 2>> edges;
    for (const auto& [ends, sides] : normals)
    {
        // Faces may be listed twice, or turned the other way.
        const auto along = [&front = sides[0]](const Eigen::Vector3d& side)
        { return std::abs(side.dot(front)) > kFlat; };
        const bool flat = sides.size() > 1 && std::ranges::all_of(sides, along);
        if (!flat)
            edges.push_back({mesh.vertices[ends.first], mesh.vertices[ends.second]});
    }
    return edges;
}

std::string trianglePath(const View& view, const std::array<Eigen::Vector3d, 3>& triangle)
{
    std::array<Eigen::Vector2d, 3> corners{view(triangle[0]), view(triangle[1]), view(triangle[2])};
    const Eigen::Vector2d a = corners[1] - corners[0];
    const Eigen::Vector2d b = corners[2] - corners[0];
    const double area = a.x() * b.y() - a.y() * b.x();
    if (std::abs(area) < 0.01)
        return {};
    if (area < 0.0)
        std::swap(corners[1], corners[2]);
    std::string path;
    append(path, 'M', corners[0]);
    append(path, 'L', corners[1]);
    append(path, 'L', corners[2]);
    return path + 'z';
}

std::string linesPath(const View& view, const std::vector<std::array<Eigen::Vector3d, 2>>& lines)
{
    std::string path;
    for (const auto& [from, to] : lines)
    {
        if ((view(from) - view(to)).norm() < 0.1)
            continue;
        append(path, 'M', view(from));
        append(path, 'L', view(to));
    }
    return path;
}

std::string pointsPath(const View& view, const std::vector<Eigen::Vector3d>& points)
{
    std::string path;
    for (const Eigen::Vector3d& point : points)
    {
        append(path, 'M', view(point));
        path += "h0";
    }
    return path;
}
}  // namespace specplan::command
