// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "specplan/problems/GridMap.h"

namespace specplan::make_scenes
{
/// A map and the name of its file, without folder.
struct Scene
{
    std::string file;
    problems::GridMap map;
};

/// Rooms of different sizes in rows, with doors in most of their walls.
[[nodiscard]] problems::GridMap makeRooms(int size);

/// Corridors three cells wide; a spanning tree of them plus some openings, so that there is more than one way.
[[nodiscard]] problems::GridMap makeMaze(int size);

/// Single cells blocked at random, three in ten.
[[nodiscard]] problems::GridMap makeRandom(int size);

/// Blocks of buildings between streets of different widths, with squares and courtyards.
[[nodiscard]] problems::GridMap makeCity(int size);

/// One straight corridor, seven cells wide.
[[nodiscard]] problems::GridMap makeCorridor(int length);

/// All scenes that come with the project; the same on every machine.
[[nodiscard]] std::vector<Scene> makeAllScenes();
}  // namespace specplan::make_scenes
