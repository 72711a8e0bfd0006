// SPDX-License-Identifier: BSD-3-Clause
// specplan plan --html on rigid bodies: what the page holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "Command.h"
#include "specplan/problems/fcl/RigidBodySetup.h"

namespace specplan::test
{
namespace
{
std::size_t occurrences(const std::string& text, const std::string& what)
{
    std::size_t count = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

/// A page that was written, taken apart.
struct Page
{
    std::string text;
    nlohmann::json scene;
    nlohmann::json points;

    explicit Page(std::string page) : text(std::move(page)), scene(json("scene")), points(json("points"))
    {
    }

private:
    [[nodiscard]] nlohmann::json json(const std::string& id) const
    {
        const std::string open = "<script id=\"" + id + "\" type=\"application/json\">";
        const auto begin = text.find(open) + open.size();
        return nlohmann::json::parse(text.substr(begin, text.find("</script>", begin) - begin));
    }
};

class RigidBodyView : public testing::Test
{
protected:
    [[nodiscard]] std::string page() const
    {
        return "'" + folder_ / "a.html" + "'";
    }

    TemporaryFolder folder_;
};

TEST_F(RigidBodyView, HoldsTheProblemAndTheSearch)
{
    for (const bool planar : {true, false})
    {
        const std::string file = scene(planar ? "office.cfg" : "piano.cfg");
        const Outcome outcome = call("plan '" + file + "' --threads 8 --executor virtual --time-limit 200s --json " +
                                     "--html " + page() + " --trace '" + folder_ / "a.json" + "'");
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(folder_.files(), 2) << "nothing besides page and trace";
        const nlohmann::json trace = nlohmann::json::parse(folder_.read("a.json"));
        const problems::RigidBodySetup setup(problems::readOmplAppProblem(file));
        const Page page(folder_.read("a.html"));
        EXPECT_LT(page.text.size(), 10'000'000U);
        EXPECT_EQ(page.scene["planar"], planar);
        EXPECT_EQ(page.scene["name"], planar ? "office" : "piano");
        for (const auto& [name, mesh] : {std::pair("world", &setup.world()), std::pair("robot", &setup.robot())})
        {
            EXPECT_EQ(page.scene[name]["triangles"].size(), mesh->triangles.size());
            EXPECT_EQ(page.scene[name]["vertices"].size(), 3 * mesh->vertices.size());
        }
        ASSERT_EQ(page.scene["path"].size(), trace["path"].size());
        for (std::size_t i = 0; i < trace["path"].size(); ++i)
            for (std::size_t axis = 0; axis < (planar ? 2U : 3U); ++axis)
                EXPECT_EQ(page.scene["path"][i][axis], trace["path"][i][axis]) << "state " << i;
        EXPECT_EQ(page.scene["path"].front(), page.scene["start"]);
        EXPECT_EQ(page.scene["path"].back(), page.scene["goal"]);
        const std::size_t expanded = trace["expanded"].size();
        const std::size_t step = page.points["step"];
        EXPECT_EQ(page.points["expanded"]["count"], expanded);
        EXPECT_EQ(page.points["expanded"]["points"].size(), 3 * ((expanded + step - 1) / step));
        EXPECT_GE(page.points["unused"]["count"], planar ? 0 : 1);
        EXPECT_NEAR(page.points["expanded"]["points"][0].get<double>(), trace["expanded"][0][0].get<double>(), 1e-3);
    }
}

TEST_F(RigidBodyView, IsWholeAndLoadsNothing)
{
    ASSERT_EQ(call("plan '" + scene("office.cfg") + "' --planner RRTConnect --html " + page()).status, 0);
    const Page page(folder_.read("a.html"));
    EXPECT_EQ(page.text.rfind("<!DOCTYPE html>", 0), 0U);
    EXPECT_EQ(page.text.substr(page.text.size() - 8), "</html>\n");
    for (const char* part : {"TITLE", "THREE_JS", "ORBIT_CONTROLS_JS", "SCENE", "POINTS"})
        EXPECT_EQ(page.text.find(std::string("{{") + part), std::string::npos) << part;
    EXPECT_EQ(occurrences(page.text, "<script"), 5U);
    EXPECT_EQ(occurrences(page.text, "</script"), 5U);
    EXPECT_NE(page.text.find("Copyright (c) 2010-2019 three.js authors"), std::string::npos);
    EXPECT_NE(page.text.find("default-src 'none'"), std::string::npos);
    const std::regex reference("(src|href|action|data) *= *[\"']?([a-z]+:)?//|@import|<link|<iframe|<img");
    EXPECT_FALSE(std::regex_search(page.text, reference));
    EXPECT_EQ(page.points["expanded"]["count"], 0) << "not known of other planners";
    EXPECT_GE(page.scene["path"].size(), 2U);
}

TEST_F(RigidBodyView, ShowsASearchWithoutAPath)
{
    ASSERT_EQ(call("plan '" + scene("piano.cfg") + "' --time-limit 1ms --html " + page()).status, 1);
    const Page page(folder_.read("a.html"));
    EXPECT_TRUE(page.scene["path"].empty());
    EXPECT_EQ(page.scene["facts"][0], "no path: timeout");
    EXPECT_FALSE(page.scene["goal"].empty());
}

TEST_F(RigidBodyView, TakesNamesThatHtmlDoesNot)
{
    const std::string name = "</script><b>&\"\xff";
    std::string problem = "[problem]\nname = " + name + "\n";
    for (const char* mesh : {"robot", "world"})
        problem += std::string(mesh) + " = " SPECPLAN_SCENES_DIR "/passage-" + mesh + ".obj\n";
    problem += "start.x = -1.5\nstart.y = 0\nstart.theta = 0\ngoal.x = -1.4\ngoal.y = 0\ngoal.theta = 0\n";
    const Outcome outcome = call("plan '" + folder_.write("a.cfg", problem) + "' --html " + page());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Page page(folder_.read("a.html"));
    EXPECT_EQ(page.scene["name"], "</script><b>&\"\xef\xbf\xbd");
    EXPECT_NE(page.text.find("<title>&lt;/script&gt;&lt;b&gt;&amp;"), std::string::npos);
    EXPECT_EQ(occurrences(page.text, "</script"), 5U);
}

TEST_F(RigidBodyView, IsRefusedInOneLine)
{
    struct Bad
    {
        std::string arguments;
        std::string complaint;
    };
    const std::string office = "plan '" + scene("office.cfg") + "' --html ";
    const std::vector<Bad> bad{
        {"plan '" + scene("city-64.map") + "' --html " + page(),
         "specplan: --html is for rigid bodies (.cfg); --svg draws maps\n"},
        {office + "'" + folder_ / "none/a.html" + "'", "a.html: cannot be written: No such file or directory\n"},
        {office + "'" + folder_ / "." + "'", "cannot be written: it is a directory\n"}};
    for (const Bad& each : bad)
    {
        const Outcome outcome = call(each.arguments);
        EXPECT_EQ(outcome.status, 2) << each.arguments;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(each.complaint), std::string::npos) << outcome.err;
        EXPECT_EQ(folder_.files(), 0);
    }
}
}  // namespace
}  // namespace specplan::test
