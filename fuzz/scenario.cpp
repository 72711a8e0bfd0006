// SPDX-License-Identifier: BSD-3-Clause
// Scenarios of the Moving AI Lab.
#include <cmath>

#include "FuzzInput.h"
#include "specplan/problems/MovingAi.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return specplan::fuzz::readInput(data, size,
                                     [](const std::string& path)
                                     {
                                         for (const auto& entry : specplan::problems::readMovingAiScenario(path))
                                             if (entry.map.empty() || !std::isfinite(entry.optimalLength))
                                                 specplan::fuzz::fail("an entry without map or length", entry.map);
                                     });
}
