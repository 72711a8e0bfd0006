// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/PlannerSettings.h"

namespace specplan
{
const std::vector<std::string>& speculationPolicies()
{
    static const std::vector<std::string> policies{"none", "direction", "runahead"};
    return policies;
}

const std::vector<std::string>& evaluations()
{
    static const std::vector<std::string> names{"eager", "lazy"};
    return names;
}

const std::vector<std::string>& predictors()
{
    static const std::vector<std::string> names{"optimistic", "nearby", "learning"};
    return names;
}
}  // namespace specplan
