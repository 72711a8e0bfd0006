// SPDX-License-Identifier: BSD-3-Clause
// Writes the rigid-body scenes of demos/scenes: OMPL.app's problem files with meshes in OBJ format and maps of voxels
// in OctoMap's.
#include <exception>
#include <filesystem>
#include <iostream>

#include "RigidScenes.h"

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::cerr << "usage: specplan_make_meshes FOLDER\n";
        return 2;
    }
    try
    {
        std::filesystem::create_directories(argv[1]);
        for (const auto& scene : specplan::make_meshes::makeAllRigidScenes())
            specplan::make_meshes::writeRigidScene(argv[1], scene);
    }
    catch (const std::exception& error)
    {
        std::cerr << "specplan_make_meshes: " << error.what() << '\n';
        return 2;
    }
    return 0;
}
