// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace demo
{
using Point = std::array<double, 2>;
using Points = std::vector<Point>;

/// The smallest convex polygon around the points: the shadow of a box or any other convex body.
[[nodiscard]] Points convexHull(Points points);

/// A picture made of panels side by side, written as SVG. Each panel shows a rectangle of a plane, y upwards.
class Drawing
{
public:
    struct Panel
    {
        std::string title;
        double left, right, bottom, top;  ///< in the units of the scene
    };

    Drawing(std::string title, std::vector<Panel> panels);

    /// \param style SVG attributes, such as `fill="gray"`; lengths in the units of the scene.
    void polygon(std::size_t panel, const Points& points, const std::string& style);
    void line(std::size_t panel, const Points& points, const std::string& style);
    void circle(std::size_t panel, const Point& centre, double radius, const std::string& style);

    /// Makes the folders above the file too. \throws std::runtime_error if it cannot be written.
    void save(const std::filesystem::path& file) const;

private:
    void shape(std::size_t panel, const char* element, const Points& points, const std::string& style);

    std::string title_;
    std::vector<Panel> panels_;
    std::vector<std::ostringstream> contents_;
};
}  // namespace demo
