// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "Command.h"
#include "PlannedLength.h"
#include "Scenarios.h"

namespace specplan::make_scenes
{
namespace
{
std::string contents(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

TEST(Scenes, FilesAreWhatTheGeneratorWrites)
{
    const test::TemporaryFolder folder;
    std::ptrdiff_t files = 0;
    for (const Scene& scene : makeAllScenes())
    {
        problems::writeMovingAiMap(folder / scene.file, scene.map);
        problems::writeMovingAiScenario(folder / (scene.file + ".scen"), makeScenario(scene.map, scene.file));
        EXPECT_EQ(folder.read(scene.file), contents(test::scene(scene.file))) << scene.file;
        EXPECT_EQ(folder.read(scene.file + ".scen"), contents(test::scene(scene.file + ".scen"))) << scene.file;
        files += 2;
    }
    const auto isMap = [](const std::filesystem::directory_entry& entry)
    { return entry.path().extension() == ".map" || entry.path().extension() == ".scen"; };
    EXPECT_EQ(std::count_if(std::filesystem::directory_iterator(SPECPLAN_SCENES_DIR),
                            std::filesystem::directory_iterator(), isMap),
              files);
}

TEST(Scenes, PlannerFindsTheScenariosOptimalLengths)
{
    for (const Scene& scene : makeAllScenes())
        for (const problems::ScenarioEntry& entry : problems::readMovingAiScenario(test::scene(scene.file + ".scen")))
            EXPECT_NEAR(test::plannedLength(scene.map, entry), entry.optimalLength, 1e-6)
                << scene.file << ' ' << entry.bucket;
}

TEST(Distances, DoNotCutCorners)
{
    problems::GridMap map(3, 2);
    for (const auto& [x, y] : {problems::GridCell{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}})
        map.setFree(x, y, true);
    const std::vector<double> distances = distancesFrom(map, {0, 0});
    EXPECT_EQ(distances[5], 3.0);
    EXPECT_EQ(distances[2], 4.0);
    EXPECT_FALSE(std::isfinite(distances[1]));
}
}  // namespace
}  // namespace specplan::make_scenes
