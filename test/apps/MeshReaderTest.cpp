// SPDX-License-Identifier: BSD-3-Clause
// Damaged meshes: the command says so in one line, whatever becomes of the library that reads them.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "Command.h"
#include "Replaced.h"

namespace specplan::test
{
namespace
{
constexpr const char* kCollada = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="s"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor count="3" source="#a" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<triangles count="1"><input offset="0" semantic="VERTEX" source="#v"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="vs"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#vs"/></scene></COLLADA>
)";

constexpr const char* kConfig =
    "[problem]\nrobot = robot.dae\nworld = world.dae\nstart.x = 5\nstart.y = 5\nstart.theta = 0\ngoal.x = 6\n"
    "goal.y = 6\ngoal.theta = 0\nvolume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 9\nvolume.max.y = 9\n";

class DamagedMesh : public testing::Test
{
protected:
    [[nodiscard]] Outcome planIn(const std::string& world) const
    {
        static_cast<void>(folder_.write("world.dae", world));
        return call("plan '" + config_ + "' --time-limit 10s --json");
    }

    TemporaryFolder folder_;
    std::string robot_ = folder_.write("robot.dae", kCollada);
    std::string config_ = folder_.write("a.cfg", kConfig);
};

TEST_F(DamagedMesh, GoodOnesAreRead)
{
    const Outcome outcome = planIn(kCollada);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST_F(DamagedMesh, CannotCrashOrHangTheCommand)
{
    const std::vector<std::string> bad{
        replaced(kCollada, "count=\"9\"", "count=\"0\""),
        replaced(kCollada, "count=\"9\"", "count=\"x\""),
        replaced(kCollada, "count=\"9\"", "count=\"4000000000\""),
        replaced(kCollada, "count=\"9\"", "count=\"8\""),
        replaced(kCollada, "<p>0 1 2", "<p>0 1x 2"),
        replaced(kCollada, "<p>0 1 2", "<p>0 1 3"),
        replaced(kCollada, "<p>0 1 2", "<p>0 1 -2"),
        replaced(kCollada, "<p>0 1 2", "<p>0 1 99999999999"),
        replaced(kCollada, "stride=\"3\"", "stride=\"1000000\""),
        replaced(kCollada, "accessor count=\"3\"", "accessor count=\"3000000\""),
        replaced(kCollada, "<instance_geometry url=\"#g\"/>", "<instance_node url=\"#n\"/>")};
    for (const std::string& each : bad)
    {
        const Outcome outcome = planIn(each);
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 2) << outcome.status;
        if (outcome.status == 0)
            continue;  // Assimp made something of it
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find("world.dae:"), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find("expected "), std::string::npos) << outcome.err;
    }
}

TEST_F(DamagedMesh, HasOneLineWhateverTheDamage)
{
    constexpr unsigned kMutants = 60;
    constexpr unsigned kSeed = 20261122;
    std::mt19937 random(kSeed);
    const std::string good = kCollada;
    for (unsigned mutant = 0; mutant < kMutants; ++mutant)
    {
        std::string text = good;
        for (auto changes = 1 + random() % 3; changes > 0; --changes)
        {
            const std::size_t at = random() % text.size();
            if (random() % 3 == 0)
                text.erase(at, random() % 40);
            else
                text[at] = static_cast<char>(random() % 2 == 0 ? '0' + random() % 75 : random() % 256);
        }
        const Outcome outcome = planIn(text);
        EXPECT_TRUE(outcome.status >= 0 && outcome.status <= 2) << "mutant " << mutant << " of seed " << kSeed;
        EXPECT_LE(std::ranges::count(outcome.err, '\n'), 1) << mutant << ": " << outcome.err;
        EXPECT_EQ(outcome.err.empty(), outcome.status != 2) << mutant << ": " << outcome.err;
    }
}

TEST_F(DamagedMesh, ARobotLargerThanTheWorldIsAWarning)
{
    static_cast<void>(folder_.write("robot.dae", replaced(kCollada, "0 0 0 1 0 0 0 1 0", "0 0 0 2 0 0 0 2 0")));
    const Outcome outcome = planIn(kCollada);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("a.cfg:2: the robot, 2 x 0 x 2, is larger than the world, 1 x 0 x 1; are both in the "
                               "same unit?\n"),
              std::string::npos)
        << outcome.err;
}
}  // namespace
}  // namespace specplan::test
