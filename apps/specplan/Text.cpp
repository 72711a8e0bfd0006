// SPDX-License-Identifier: BSD-3-Clause
#include "Text.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "specplan/problems/InputError.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
using problems::concat;
using problems::InputError;

std::chrono::nanoseconds parseDuration(const std::string& option, const std::string& text)
{
    constexpr std::array<std::pair<std::string_view, double>, 4> kUnits{
        {{"ns", 1.0}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}}};
    constexpr double kLongest = 1e18;
    for (const auto& [unit, nanoseconds] : kUnits)
    {
        double value = 0.0;
        if (text.size() > unit.size() && text.ends_with(unit) &&
            problems::parse(std::string_view(text).substr(0, text.size() - unit.size()), value) && value >= 0.0 &&
            value * nanoseconds <= kLongest)
            return std::chrono::nanoseconds(std::llround(value * nanoseconds));
    }
    throw InputError(
        concat(option, ": expected a duration such as 5ms (ns, us, ms or s), found ", problems::inQuotes(text)));
}

problems::GridCell parseCell(const std::string& option, const std::string& text)
{
    const auto parts = problems::split(text, ",");
    problems::GridCell cell{};
    if (parts.size() != 2 || !problems::parse(parts[0], cell[0]) || !problems::parse(parts[1], cell[1]))
        throw InputError(concat(option, ": expected a cell x,y, found ", problems::inQuotes(text)));
    return cell;
}

std::vector<unsigned> parseWorkers(const std::string& option, const std::string& text)
{
    constexpr int kMost = 4096;
    std::set<unsigned> workers;
    std::istringstream parts(text + ',');
    for (std::string part; std::getline(parts, part, ',');)
    {
        const auto dots = part.find("..");
        int first = 0;
        int last = 0;
        const bool read = problems::parse(std::string_view(part).substr(0, dots), first) &&
                          problems::parse(std::string_view(part).substr(dots == part.npos ? 0 : dots + 2), last);
        if (!read || first < 1 || last < first || last > kMost)
            throw InputError(concat(option, ": expected numbers from 1 to 4096 such as 1,2,4 or 1..256, found ",
                                    problems::inQuotes(text)));
        for (int next = first; next < last; next *= 2)
            workers.insert(static_cast<unsigned>(next));
        workers.insert(static_cast<unsigned>(last));
    }
    return {workers.begin(), workers.end()};
}

std::string fixed(double value, int places)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(places) << value;
    return text.str();
}

std::string durationText(double seconds)
{
    if (seconds < 1e-3)
        return fixed(seconds * 1e6, 1) + " us";
    if (seconds < 1.0)
        return fixed(seconds * 1e3, 1) + " ms";
    return fixed(seconds, 2) + " s";
}

std::string jsonText(const nlohmann::ordered_json& json)
{
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string compactJsonText(const nlohmann::ordered_json& json)
{
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text)
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return out;
}
}  // namespace specplan::command
