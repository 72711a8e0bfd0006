// SPDX-License-Identifier: BSD-3-Clause
// Maps of OctoMap.
#include <octomap/octomap.h>

#include "FuzzInput.h"
#include "specplan/problems/fcl/OctoMap.h"

namespace
{
bool hasOccupiedVoxels(const octomap::OcTree& map)
{
    for (auto leaf = map.begin_leafs(), end = map.end_leafs(); leaf != end; ++leaf)
        if (map.isNodeOccupied(*leaf))
            return true;
    return false;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return specplan::fuzz::readInput(data, size,
                                     [](const std::string& path)
                                     {
                                         if (!hasOccupiedVoxels(*specplan::problems::readOctoMap(path)))
                                             specplan::fuzz::fail("a map without occupied voxels", path);
                                     });
}
