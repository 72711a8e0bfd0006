// SPDX-License-Identifier: BSD-3-Clause
#include "PlannerList.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "specplan/problems/InputError.h"
#include "specplan/problems/PlannerCatalog.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
using problems::concat;
using problems::InputError;
using problems::PlannerRequest;

PlannerRequest parsePlanner(const std::string& text)
{
    const std::size_t colon = text.find(':');
    PlannerRequest request;
    request.name = text.substr(0, colon);
    if (!problems::isPlannerName(request.name))
        throw InputError(concat("planner '", request.name, "' is not known; expected SpeculativeAStar or one of ",
                                "OMPL's, such as RRTConnect or BITstar"));
    if (colon == std::string::npos)
        return request;
    for (const std::string_view part : problems::split(std::string_view(text).substr(colon + 1), ";"))
    {
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos || equals == 0)
            throw InputError(concat("planner ", request.name, ": expected key=value, found '", part, "'"));
        request.parameters[std::string(part.substr(0, equals))] = part.substr(equals + 1);
    }
    std::string name = text;
    std::ranges::replace(name, ';', ' ');
    request.parameters.try_emplace("name", name);
    return request;
}

std::vector<PlannerRequest> parsePlanners(const std::string& text)
{
    std::vector<std::string> parts;
    for (const std::string_view part : problems::split(text, ","))
        if (!parts.empty() && std::isdigit(static_cast<unsigned char>(part.front())) != 0)
            parts.back() += concat(',', part);
        else
            parts.emplace_back(part);
    std::vector<PlannerRequest> requests;
    std::set<std::string> names;
    for (const std::string& part : parts)
    {
        requests.push_back(parsePlanner(part));
        const auto& parameters = requests.back().parameters;
        const std::string name = parameters.contains("name") ? parameters.at("name") : requests.back().name;
        if (!names.insert(name).second)
            throw InputError(concat("--planners: expected '", name, "' once; name=OTHER tells two of a kind apart"));
    }
    if (requests.empty())
        throw InputError("--planners: expected at least one planner");
    return requests;
}
}  // namespace specplan::command
