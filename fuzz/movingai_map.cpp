// SPDX-License-Identifier: BSD-3-Clause
// Maps of the Moving AI Lab.
#include "FuzzInput.h"
#include "specplan/problems/MovingAi.h"

using specplan::problems::GridMap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return specplan::fuzz::readInput(data, size,
                                     [](const std::string& path)
                                     {
                                         const GridMap map = specplan::problems::readMovingAiMap(path);
                                         if (map.width() < 1 || map.height() < 1)
                                             specplan::fuzz::fail("a map without cells", path);
                                     });
}
