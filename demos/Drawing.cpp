// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace demo
{
namespace
{
constexpr double kHeight = 360.0;  // pixels of a panel
constexpr double kMargin = 16.0;   // pixels
constexpr double kTitle = 44.0;    // pixels above the panels

double turn(const Point& a, const Point& b, const Point& c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
}  // namespace

Points convexHull(Points points)
{
    // Andrew's monotone chain: the lower side from left to right, then the upper side back.
    std::ranges::sort(points);
    Points hull;
    for (int side = 0; side < 2; ++side)
    {
        const std::size_t first = hull.size();
        for (const Point& point : points)
        {
            while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

Drawing::Drawing(std::string title, std::vector<Panel> panels)
    : title_(std::move(title)), panels_(std::move(panels)), contents_(panels_.size())
{
}

void Drawing::shape(std::size_t panel, const char* element, const Points& points, const std::string& style)
{
    std::ostringstream& out = contents_.at(panel);
    out << '<' << element << ' ' << style << " points=\"";
    for (const Point& point : points)
        out << point[0] << ',' << -point[1] << ' ';  // SVG's y points down
    out << "\"/>\n";
}

void Drawing::polygon(std::size_t panel, const Points& points, const std::string& style)
{
    shape(panel, "polygon", points, style);
}

void Drawing::line(std::size_t panel, const Points& points, const std::string& style)
{
    shape(panel, "polyline", points, "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" " + style);
}

void Drawing::circle(std::size_t panel, const Point& centre, double radius, const std::string& style)
{
    contents_.at(panel) << "<circle cx=\"" << centre[0] << "\" cy=\"" << -centre[1] << "\" r=\"" << radius << "\" "
                        << style << "/>\n";
}

void Drawing::save(const std::filesystem::path& file) const
{
    std::ostringstream body;
    double x = kMargin;
    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        const Panel& panel = panels_[i];
        const double width = kHeight * (panel.right - panel.left) / (panel.top - panel.bottom);
        body << "<text x=\"" << x << "\" y=\"38\">" << panel.title << "</text>\n<svg x=\"" << x << "\" y=\"" << kTitle
             << "\" width=\"" << width << "\" height=\"" << kHeight << "\" viewBox=\"" << panel.left << ' '
             << -panel.top << ' ' << panel.right - panel.left << ' ' << panel.top - panel.bottom << "\">\n<rect x=\""
             << panel.left << "\" y=\"" << -panel.top << "\" width=\"100%\" height=\"100%\" fill=\"#f7f7f5\"/>\n"
             << contents_[i].str() << "</svg>\n";
        x += width + kMargin;
    }
    if (file.has_parent_path())
        std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << x << "\" height=\"" << kTitle + kHeight + kMargin
        << "\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        << "<text x=\"" << kMargin << "\" y=\"20\" font-weight=\"bold\">" << title_ << "</text>\n"
        << body.str() << "</svg>\n";
    if (!out.flush())
        throw std::runtime_error("cannot write " + file.string());
}
}  // namespace demo
