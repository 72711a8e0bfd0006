// SPDX-License-Identifier: BSD-3-Clause
// Maps in the format of the paper's program.
#include "FuzzInput.h"
#include "specplan/problems/SeedMap.h"
#include "specplan/problems/TextFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return specplan::fuzz::readInput(data, size,
                                     [](const std::string& path)
                                     {
                                         (void)specplan::problems::looksLikeSeedMap(specplan::problems::readText(path));
                                         const auto problem = specplan::problems::readSeedMap(path);
                                         if (!problem.map.contains(problem.start[0], problem.start[1]) ||
                                             !problem.map.contains(problem.goal[0], problem.goal[1]))
                                             specplan::fuzz::fail("start or goal off the map", path);
                                     });
}
