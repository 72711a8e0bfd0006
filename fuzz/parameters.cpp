// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the planner, set by text: "name=value" in each line.
#include <sstream>

#include <ompl/base/GenericParam.h>
#include <ompl/util/Console.h>

#include "FuzzInput.h"
#include "specplan/planner/PlannerParameters.h"

namespace
{
using specplan::PlannerSettings;

/// A parameter is set, or refused with the old value as it was. What it says of itself sets it to the same again.
void set(ompl::base::ParamSet& params, const std::string& name, const std::string& value)
{
    const std::string before = params.hasParam(name) ? params[name].getValue() : "";
    if (!params.setParam(name, value))
    {
        if (params.hasParam(name) && params[name].getValue() != before)
            specplan::fuzz::fail("a refused value was taken", name + '=' + value);
        return;
    }
    const std::string now = params[name].getValue();
    if (!params.setParam(name, now) || params[name].getValue() != now)
        specplan::fuzz::fail("a value does not read back", name + '=' + now);
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    PlannerSettings settings;
    ompl::base::ParamSet params;
    specplan::planner::declareParameters(
        params, [&] { return settings; },
        [&](const PlannerSettings& changed)
        {
            try
            {
                specplan::planner::validate(changed);
            }
            catch (const std::invalid_argument& error)
            {
                specplan::fuzz::requireOneLine(error.what());
                throw;
            }
            settings = changed;
        });
    std::istringstream lines(std::string(reinterpret_cast<const char*>(data), size));
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t equals = line.find('='); equals != line.npos)
            set(params, line.substr(0, equals), line.substr(equals + 1));
    specplan::planner::validate(settings);
    return 0;
}
