// SPDX-License-Identifier: BSD-3-Clause
// Writes the scenes of demos/scenes: maps in the Moving AI Lab's format, each with a scenario.
#include <exception>
#include <filesystem>
#include <iostream>

#include "Scenarios.h"
#include "Scenes.h"
#include "specplan/problems/MovingAi.h"

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::cerr << "usage: specplan_make_scenes FOLDER\n";
        return 2;
    }
    try
    {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        for (const auto& scene : specplan::make_scenes::makeAllScenes())
        {
            const std::string path = (folder / scene.file).string();
            specplan::problems::writeMovingAiMap(path, scene.map);
            specplan::problems::writeMovingAiScenario(path + ".scen",
                                                      specplan::make_scenes::makeScenario(scene.map, scene.file));
        }
    }
    catch (const std::exception& error)
    {
        std::cerr << "specplan_make_scenes: " << error.what() << '\n';
        return 2;
    }
    return 0;
}
