// SPDX-License-Identifier: BSD-3-Clause
#include "RigidBodyPicture.h"

#include <algorithm>
#include <ostream>

#include "Colours.h"
#include "MeshDrawing.h"
#include "RigidBodyStates.h"
#include "Text.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
using Eigen::Vector3d;
using problems::concat;
using problems::Mesh;

namespace
{
constexpr double kWidth = 900.0;  // pixels
constexpr double kMargin = 12.0;
constexpr double kTitle = 26.0;
constexpr double kLegend = 30.0;
constexpr std::size_t kMostDots = 20000;
constexpr std::size_t kMostTriangles = 12000;  // of robots along the path, all views together

/// A view and the pixels it may draw on.
struct Panel
{
    View view;
    Eigen::AlignedBox2d box;
    const char* title;
};

Panel makePanel(int right, int up, const Eigen::AlignedBox3d& space, double left, double top, double scale,
                const char* title)
{
    Panel panel{{right, up, {left - scale * space.min()[right], top + scale * space.max()[up]}, scale}, {}, title};
    panel.box.extend(Eigen::Vector2d(left, top));
    panel.box.extend(Eigen::Vector2d(left + scale * space.sizes()[right], top + scale * space.sizes()[up]));
    return panel;
}

/// From above; in space also from the front and from the right, below, at the same scale.
std::vector<Panel> makePanels(const Eigen::AlignedBox3d& space, bool planar)
{
    const double wide = planar ? space.sizes().x() : space.sizes().x() + space.sizes().y();
    const double gaps = planar ? 2.0 * kMargin : 3.0 * kMargin;
    const double scale = (kWidth - gaps) / wide;
    std::vector<Panel> panels{makePanel(0, 1, space, kMargin, kTitle, scale, "from above")};
    if (planar)
        return panels;
    const double below = panels[0].box.max().y() + kMargin;
    panels.push_back(makePanel(0, 2, space, kMargin, below, scale, "from the front"));
    panels.push_back(makePanel(1, 2, space, panels[0].box.max().x() + kMargin, below, scale, "from the right"));
    return panels;
}

/// What the robot can meet in the plane: the parts of the world at its height, without what is below it, such as a
/// floor that belongs to the walls.
Mesh worldInThePlane(const problems::RigidBodySetup& setup)
{
    const Eigen::AlignedBox3d robot = boundsOf(setup.robot());
    Mesh plane;
    for (const Mesh& part : connectedParts(setup.world()))
    {
        const Eigen::AlignedBox3d box = boundsOf(part);
        if (box.max().z() < robot.min().z() || box.min().z() > robot.max().z())
            continue;
        const auto first = static_cast<std::uint32_t>(plane.vertices.size());
        plane.vertices.insert(plane.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const auto& [a, b, c] : part.triangles)
            if (std::max({part.vertices[a].z(), part.vertices[b].z(), part.vertices[c].z()}) > robot.min().z())
                plane.triangles.push_back({first + a, first + b, first + c});
    }
    return plane;
}

std::array<Vector3d, 3> cornersOf(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle,
                                  const Eigen::Isometry3d& pose)
{
    return {pose * mesh.vertices[triangle[0]], pose * mesh.vertices[triangle[1]], pose * mesh.vertices[triangle[2]]};
}

class Drawing
{
public:
    Drawing(std::ostream& out, const problems::RigidBodySetup& setup, const Run& run)
        : out_(out),
          setup_(setup),
          run_(run),
          states_(setup, run),
          planar_(setup.problem().planar),
          panels_(makePanels(withMargin(states_.space()), planar_))
    {
    }

    void draw()
    {
        const double bottom = panels_.back().box.max().y();
        const double height = bottom + kMargin + kLegend;
        out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kWidth << "\" height=\"" << height
             << "\" viewBox=\"0 0 " << kWidth << ' ' << height
             << "\" font-family=\"sans-serif\" font-size=\"12\" stroke-linejoin=\"round\">\n<title>"
             << escaped(run_.problem) << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\""
             << kMargin << "\" y=\"18\" font-size=\"13\">"
             << escaped(concat(run_.problem, ": ", run_.plannerName, ", ", durationText(run_.seconds())))
             << "</text>\n";
        for (std::size_t i = 0; i < panels_.size(); ++i)
            drawPanel(panels_[i], i);
        drawLegend(bottom + kMargin);
        out_ << "</svg>\n";
    }

private:
    /// Where the robot may be, and then some for its size.
    static Eigen::AlignedBox3d withMargin(Eigen::AlignedBox3d space)
    {
        const double margin = 0.02 * space.diagonal().norm();
        space.min().array() -= margin;
        space.max().array() += margin;
        return space;
    }

    void drawPanel(const Panel& panel, std::size_t number)
    {
        const Eigen::Vector2d size = panel.box.sizes();
        const std::string frame = concat("x=\"", panel.box.min().x(), "\" y=\"", panel.box.min().y(), "\" width=\"",
                                         size.x(), "\" height=\"", size.y(), '"');
        out_ << "<clipPath id=\"panel" << number << "\"><rect " << frame << "/></clipPath>\n<g clip-path=\"url(#panel"
             << number << ")\">\n<rect " << frame << " fill=\"#f7f7f5\"/>\n";
        if (planar_)
            drawWorldFromAbove(panel.view);
        else
            drawWorldSeenThrough(panel.view);
        drawStates(panel.view);
        drawRobots(panel.view);
        drawPath(panel.view);
        out_ << "</g>\n";
        if (!planar_)
            out_ << "<text x=\"" << panel.box.min().x() + 4.0 << "\" y=\"" << panel.box.min().y() + 14.0
                 << "\" fill=\"#555555\">" << panel.title << "</text>\n";
    }

    void drawWorldFromAbove(const View& view)
    {
        const Mesh world = worldInThePlane(setup_);
        out_ << "<path fill=\"" << kWallColour << "\" d=\"";
        for (const auto& triangle : world.triangles)
            out_ << trianglePath(view, cornersOf(world, triangle, Eigen::Isometry3d::Identity()));
        // Walls that stand upright are lines from above.
        out_ << "\"/>\n<path fill=\"none\" stroke=\"" << kWallColour << "\" stroke-width=\"0.8\" d=\""
             << linesPath(view, featureEdges(world)) << "\"/>\n";
    }

    void drawWorldSeenThrough(const View& view)
    {
        const Mesh& world = setup_.world();
        out_ << "<g fill=\"" << kWallColour << "\" fill-opacity=\"0.06\">\n";
        for (const auto& triangle : world.triangles)
            if (const std::string path = trianglePath(view, cornersOf(world, triangle, Eigen::Isometry3d::Identity()));
                !path.empty())
                out_ << "<path d=\"" << path << "\"/>\n";
        out_ << "</g>\n<path fill=\"none\" stroke=\"" << kWallColour
             << "\" stroke-opacity=\"0.55\" stroke-width=\"0.6\" d=\"" << linesPath(view, featureEdges(world))
             << "\"/>\n";
    }

    void drawDots(const View& view, std::vector<Vector3d> points, const char* colour, double size)
    {
        if (points.empty())
            return;
        out_ << "<path fill=\"none\" stroke=\"" << colour << "\" stroke-width=\"" << size
             << "\" stroke-linecap=\"round\" d=\"" << pointsPath(view, points) << "\"/>\n";
    }

    void drawStates(const View& view)
    {
        // Evenly thinned out where there are more than a picture can show.
        const std::size_t step = run_.expanded.size() / kMostDots + 1;
        for (std::size_t shade = 0; shade < kExpandedColours.size(); ++shade)
        {
            std::vector<Vector3d> points;
            const std::size_t n = run_.expanded.size();
            for (std::size_t i = n * shade / kExpandedColours.size(); i < n * (shade + 1) / kExpandedColours.size();
                 i += step)
                points.push_back(states_.placeOf(run_.expanded[i]));
            drawDots(view, std::move(points), kExpandedColours[shade], 2.5);
        }
        const std::vector<Vector3d> all = states_.checkedAndUnused();
        std::vector<Vector3d> unused;
        for (std::size_t i = 0; i < all.size(); i += all.size() / kMostDots + 1)
            unused.push_back(all[i]);
        drawDots(view, std::move(unused), kUnusedColour, 2.0);
    }

    void drawRobot(const View& view, const Eigen::Isometry3d& pose, const char* colour, double opacity)
    {
        out_ << "<path fill=\"" << colour << "\" fill-opacity=\"" << opacity << "\" d=\"";
        for (const auto& triangle : setup_.robot().triangles)
            out_ << trianglePath(view, cornersOf(setup_.robot(), triangle, pose));
        std::vector<std::array<Vector3d, 2>> edges = robotEdges_;
        for (auto& [from, to] : edges)
        {
            from = pose * from;
            to = pose * to;
        }
        out_ << "\"/>\n<path fill=\"none\" stroke=\"" << colour << "\" stroke-width=\"0.5\" stroke-opacity=\"0.7\" d=\""
             << linesPath(view, edges) << "\"/>\n";
    }

    /// The robot at some places along the path, first and last in their own colours.
    void drawRobots(const View& view)
    {
        if (run_.path.empty())
            return drawEnds(view);
        ompl::geometric::PathGeometric path = run_.setup->getSolutionPath();
        const std::size_t cost = setup_.robot().triangles.size() * panels_.size();
        const auto count = static_cast<unsigned>(std::clamp<std::size_t>(kMostTriangles / cost, 4, planar_ ? 30 : 14));
        path.interpolate(std::max<unsigned>(count, static_cast<unsigned>(path.getStateCount())));
        const std::size_t last = path.getStateCount() - 1;
        for (unsigned i = 1; i + 1 < count; ++i)
            drawRobot(view, states_.poseOf(path.getState(static_cast<unsigned>(i * last / (count - 1)))), kRobotColour,
                      0.15);
        drawEnds(view);
    }

    void drawEnds(const View& view)
    {
        drawRobot(view, states_.start(), kStartColour, 0.6);
        drawRobot(view, states_.goal(), kPathColour, 0.6);
    }

    void drawPath(const View& view)
    {
        if (run_.path.empty())
            return;
        out_ << "<polyline fill=\"none\" stroke=\"" << kPathColour << "\" stroke-width=\"2\" points=\"";
        for (const std::vector<double>& state : run_.path)
        {
            const Eigen::Vector2d point = view(states_.placeOf(state));
            out_ << fixed(point.x(), 1) << ',' << fixed(point.y(), 1) << ' ';
        }
        out_ << "\"/>\n";
    }

    void drawLegend(double top)
    {
        const SearchReport& report = run_.report;
        struct Item
        {
            const char* colour;
            std::string text;
        };
        std::vector<Item> items{
            {kStartColour, "start"},
            {kPathColour, run_.solved() ? concat("goal and path: ", fixed(report.cost, 2)) : "goal; no path"}};
        if (run_.planner)
        {
            items.push_back({kExpandedColours[4], concat("expanded: ", report.expansions)});
            items.push_back(
                {kUnusedColour, concat("checks run ahead, never used: ",
                                       report.speculativeChecks - report.speculativeDropped - report.speculativeUsed)});
        }
        double x = kMargin;
        for (const Item& item : items)
        {
            out_ << "<rect x=\"" << x << "\" y=\"" << top << "\" width=\"12\" height=\"12\" fill=\"" << item.colour
                 << "\"/><text x=\"" << x + 17.0 << "\" y=\"" << top + 10.5 << "\">" << item.text << "</text>\n";
            x += 36.0 + 6.4 * static_cast<double>(item.text.size());
        }
    }

    std::ostream& out_;
    const problems::RigidBodySetup& setup_;
    const Run& run_;
    RigidBodyStates states_;
    bool planar_;
    std::vector<Panel> panels_;
    std::vector<std::array<Vector3d, 2>> robotEdges_ = featureEdges(setup_.robot());
};
}  // namespace

void drawSearch(std::ostream& out, const problems::RigidBodySetup& setup, const Run& run)
{
    Drawing(out, setup, run).draw();
}
}  // namespace specplan::command
