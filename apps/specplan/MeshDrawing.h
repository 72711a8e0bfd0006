// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "specplan/problems/fcl/Mesh.h"

namespace specplan::command
{
/// Edges of a mesh that an eye would draw: where it ends and where its faces bend by more than 20 degrees.
[[nodiscard]] std::vector<std::array<Eigen::Vector3d, 2>> featureEdges(const problems::Mesh& mesh);

/// A look along an axis: space to pixels.
struct View
{
    int right;               ///< axis that points to the right
    int up;                  ///< axis that points up
    Eigen::Vector2d origin;  ///< pixels of the point whose coordinates are 0
    double scale;            ///< pixels a unit

    [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector3d& point) const
    {
        return {origin.x() + scale * point[right], origin.y() - scale * point[up]};
    }
};

/// A triangle as part of an SVG path; all turn the same way, so that a path of several is filled where any is.
[[nodiscard]] std::string trianglePath(const View& view, const std::array<Eigen::Vector3d, 3>& triangle);

/// Lines as an SVG path.
[[nodiscard]] std::string linesPath(const View& view, const std::vector<std::array<Eigen::Vector3d, 2>>& lines);

/// Points as an SVG path, for a stroke with round ends.
[[nodiscard]] std::string pointsPath(const View& view, const std::vector<Eigen::Vector3d>& points);
}  // namespace specplan::command
