// SPDX-License-Identifier: BSD-3-Clause
#include "RigidBodyView.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "Colours.h"
#include "MeshDrawing.h"
#include "RigidBodyStates.h"
#include "Text.h"
#include "specplan/problems/InputError.h"
#include "viewer/Viewer.h"

namespace specplan::command
{
using Eigen::Vector3d;
using nlohmann::ordered_json;
using problems::concat;
using problems::Mesh;

namespace
{
constexpr std::size_t kMostBytes = 10'000'000;  // of a page, if points are what makes it large
constexpr std::size_t kBytesPerPoint = 30;      // at most
constexpr std::size_t kFewestPoints = 20'000;   // that are shown however large the meshes are

/// Appends a point's coordinates. \param scale what they are rounded to one part of: a power of ten, for short numbers.
void append(ordered_json& numbers, const Vector3d& point, double scale)
{
    for (const double coordinate : point)
        numbers.push_back(std::round(coordinate * scale) / scale + 0.0);  // and not -0
}

/// The power of ten that rounds to this or finer.
double scaleFor(double precision)
{
    return std::pow(10.0, std::ceil(-std::log10(precision)));
}

ordered_json toJson(const Mesh& mesh)
{
    const double scale = scaleFor(1e-7 * std::max(boundsOf(mesh).diagonal().norm(), 1e-9));
    ordered_json json{{"vertices", ordered_json::array()}, {"triangles", mesh.triangles}};
    json["edges"] = ordered_json::array();
    for (const Vector3d& vertex : mesh.vertices)
        append(json["vertices"], vertex, scale);
    for (const auto& [from, to] : featureEdges(mesh))
    {
        append(json["edges"], from, scale);
        append(json["edges"], to, scale);
    }
    return json;
}

/// Place and quaternion, x y z w.
ordered_json toJson(const Eigen::Isometry3d& pose)
{
    const Vector3d place = pose.translation();
    const Eigen::Quaterniond turn(pose.linear());
    return {place.x(), place.y(), place.z(), turn.x(), turn.y(), turn.z(), turn.w()};
}

/// JSON that may stand in a script element of HTML.
std::string scriptText(const ordered_json& json)
{
    const std::string text = json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    std::string safe;
    for (const char letter : text)
        if (letter == '<')
            safe += "\\u003c";  // "<" is nowhere but in strings
        else
            safe += letter;
    return safe;
}

class Page
{
public:
    Page(const problems::RigidBodySetup& setup, const Run& run) : setup_(setup), run_(run), states_(setup, run)
    {
    }

    void write(std::ostream& out) const
    {
        const std::string scene = scriptText(sceneJson());
        const std::size_t bytes = kViewPage.size() + kThreeJs.size() + kOrbitControlsJs.size() + scene.size();
        const std::size_t room = kMostBytes > bytes ? kMostBytes - bytes : 0;
        const std::string points = scriptText(pointsJson(std::max(room / kBytesPerPoint, kFewestPoints)));
        const std::string title = escaped(setup_.problem().name);
        const std::map<std::string_view, std::string_view> parts{{"TITLE", title},
                                                                 {"THREE_JS", kThreeJs},
                                                                 {"ORBIT_CONTROLS_JS", kOrbitControlsJs},
                                                                 {"SCENE", scene},
                                                                 {"POINTS", points}};
        std::size_t done = 0;
        for (std::size_t open = kViewPage.find("{{"); open != std::string_view::npos; open = kViewPage.find("{{", done))
        {
            const std::size_t close = kViewPage.find("}}", open);
            out << kViewPage.substr(done, open - done) << parts.at(kViewPage.substr(open + 2, close - open - 2));
            done = close + 2;
        }
        out << kViewPage.substr(done);
    }

private:
    [[nodiscard]] ordered_json sceneJson() const
    {
        const bool planar = setup_.problem().planar;
        const Eigen::AlignedBox3d space = states_.space().merged(boundsOf(setup_.world()));
        ordered_json json;
        json["name"] = setup_.problem().name;
        json["facts"] = facts();
        json["planar"] = planar;
        json["low"] = {space.min().x(), space.min().y(), space.min().z()};
        json["high"] = {space.max().x(), space.max().y(), space.max().z()};
        // In the plane poses have no height, so path and states are shown where the robot ends below.
        json["height"] = planar ? boundsOf(setup_.robot()).min().z() : 0.0;
        json["colours"] = {{"world", kWallColour},  {"robot", kRobotColour},        {"path", kPathColour},
                           {"start", kStartColour}, {"expanded", kExpandedColours}, {"unused", kUnusedColour}};
        json["start"] = toJson(states_.start());
        json["goal"] = toJson(states_.goal());
        json["path"] = ordered_json::array();
        if (run_.solved())
            for (const ompl::base::State* state : run_.setup->getSolutionPath().getStates())
                json["path"].push_back(toJson(states_.poseOf(state)));
        json["robot"] = toJson(setup_.robot());
        json["world"] = toJson(setup_.world());
        return json;
    }

    [[nodiscard]] std::vector<std::string> facts() const
    {
        const SearchReport& report = run_.report;
        std::vector<std::string> facts{
            run_.solved() ? concat("cost ", fixed(report.cost, 2), ", path of ", run_.path.size(), " states")
                          : concat("no path: ", report.status)};
        if (run_.planner)
            facts.push_back(concat(report.checksTotal, " checks run, ", report.checksUsed, " of them used"));
        const std::string threads =
            run_.planner ? concat(", ", report.threads, report.threads == 1 ? " thread" : " threads") : "";
        const char* clock = run_.settings.executor == "virtual" ? " on the virtual clock" : "";
        facts.push_back(concat(run_.plannerName, threads, ", ", durationText(run_.seconds()), clock));
        return facts;
    }

    /// States of the search, not many more than these.
    [[nodiscard]] ordered_json pointsJson(std::size_t most) const
    {
        const std::vector<Vector3d> unused = states_.checkedAndUnused();
        const std::size_t step = (run_.expanded.size() + unused.size()) / most + 1;
        const double scale = scaleFor(1e-5 * states_.space().diagonal().norm());
        ordered_json json;
        json["step"] = step;
        json["expanded"] = {{"count", run_.expanded.size()}, {"points", ordered_json::array()}};
        json["unused"] = {{"count", unused.size()}, {"points", ordered_json::array()}};
        for (std::size_t i = 0; i < run_.expanded.size(); i += step)
            append(json["expanded"]["points"], states_.placeOf(run_.expanded[i]), scale);
        for (std::size_t i = 0; i < unused.size(); i += step)
            append(json["unused"]["points"], unused[i], scale);
        return json;
    }

    const problems::RigidBodySetup& setup_;
    const Run& run_;
    RigidBodyStates states_;
};
}  // namespace

void requireViewer()
{
    if (kThreeJs.empty())
        throw problems::InputError(
            "--html needs three.js (package libjs-three), which was not there when specplan was built");
}

void viewSearch(std::ostream& out, const problems::RigidBodySetup& setup, const Run& run)
{
    requireViewer();
    Page(setup, run).write(out);
}
}  // namespace specplan::command
