// SPDX-License-Identifier: BSD-3-Clause
// Problem files of OMPL.app.
#include "FuzzInput.h"
#include "specplan/problems/OmplAppProblem.h"
#include "specplan/problems/PlannerCatalog.h"

/// A small catalogue: the real one needs every planner there is.
bool specplan::problems::isPlannerName(const std::string& name)
{
    return name == "rrtconnect" || name == "bitstar" || name == "speculativeastar";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return specplan::fuzz::readInput(data, size,
                                     [](const std::string& path)
                                     {
                                         const auto problem = specplan::problems::readOmplAppProblem(path);
                                         for (const std::string& warning : problem.warnings)
                                             specplan::fuzz::requireOneLine(warning);
                                     });
}
