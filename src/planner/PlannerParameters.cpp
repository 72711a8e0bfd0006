// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/PlannerParameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "specplan/util/ParseNumber.h"
#include "specplan/util/PrintableText.h"

namespace specplan::planner
{
namespace
{
constexpr unsigned kMaxThreads = 4096;
constexpr unsigned kMaxLookahead = 1000;
constexpr unsigned kMaxConnectivity = 1000;
constexpr double kMaxWeight = 1e9;
constexpr double kMinResolution = 1e-6;
constexpr double kMaxVirtualCost = 1e6;
constexpr double kMaxSpacing = 1e12;
/// Numbers between these are written without an exponent.
constexpr double kLeastPlain = 1e-4;
constexpr double kMostPlain = 1e7;
constexpr const char* kSpacingExpected = "numbers greater than 0 and up to 1e12, separated by commas or blanks";

[[noreturn]] void refuse(const std::string& name, const std::string& expected, const std::string& given)
{
    throw std::invalid_argument(name + " must be " + expected + ", not " + util::inQuotes(given));
}

std::string text(double value)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << value;
    // The shortest form that reads back as the same number, without an exponent where it needs none.
    const double size = std::abs(value);
    for (int digits = 1; digits < 17; ++digits)
    {
        std::ostringstream shorter;
        shorter.imbue(std::locale::classic());
        shorter.precision(digits);
        shorter << value;
        const bool plain = shorter.str().find('e') == std::string::npos || !(size >= kLeastPlain && size < kMostPlain);
        if (plain && std::stod(shorter.str()) == value)
            return shorter.str();
    }
    return out.str();
}

unsigned parseUnsigned(const std::string& name, const std::string& value, const std::string& expected)
{
    unsigned number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc{} || end != value.data() + value.size())
        refuse(name, expected, value);
    return number;
}

double parseDouble(const std::string& name, const std::string& value, const std::string& expected)
{
    double number = 0.0;
    if (!util::parseNumber(value, number))
        refuse(name, expected, value);
    return number;
}

bool parseBool(const std::string& name, const std::string& value)
{
    if (value == "1" || value == "true" || value == "yes" || value == "on")
        return true;
    if (value == "0" || value == "false" || value == "no" || value == "off")
        return false;
    refuse(name, "0 or 1", value);
}

/// Numbers separated by commas, semicolons or blanks; in brackets too, as ROS writes an array that is a string.
std::vector<double> parseSpacing(const std::string& value)
{
    constexpr const char* kBlanks = " \t";
    const auto trimmed = [](std::string_view part)
    {
        const std::size_t first = part.find_first_not_of(kBlanks);
        return first == part.npos ? std::string_view() : part.substr(first, part.find_last_not_of(kBlanks) - first + 1);
    };
    std::string_view rest = trimmed(value);
    if (rest.size() >= 2 && rest.front() == '[' && rest.back() == ']')
        rest = trimmed(rest.substr(1, rest.size() - 2));
    std::vector<double> spacing;
    while (!rest.empty())
    {
        const std::size_t end = std::min(rest.find_first_of(" \t,;"), rest.size());
        const std::string_view number = rest.substr(0, end);
        spacing.push_back(parseDouble("spacing", std::string(number), kSpacingExpected));
        rest = trimmed(rest.substr(end));
        if (rest.empty() || (rest.front() != ',' && rest.front() != ';'))
            continue;
        rest = trimmed(rest.substr(1));
        if (rest.empty())
            refuse("spacing", kSpacingExpected, value);
    }
    return spacing;
}

std::string spacingText(const std::vector<double>& spacing)
{
    std::string out;
    for (const double value : spacing)
    {
        if (!out.empty())
            out += ',';
        out += text(value);
    }
    return out;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string out;
    for (const std::string& name : names)
    {
        if (!out.empty())
            out += ',';
        out += name;
    }
    return out;
}

void requireRange(const std::string& name, double value, double low, double high, bool zeroToo)
{
    const bool inside = value >= low && value <= high;  // false for NaN
    if (!inside && !(zeroToo && value == 0.0))
    {
        std::string expected = zeroToo && low > 0.0 ? "0, or between " : "between ";
        expected += text(low) + " and " + text(high);
        refuse(name, expected, text(value));
    }
}

void requireOneOf(const std::string& name, const std::string& value, const std::vector<std::string>& names)
{
    if (std::ranges::find(names, value) == names.end())
        refuse(name, "one of " + joined(names), value);
}

/// Declares a parameter from a member of the settings and how to read and write it.
class Declarer
{
public:
    Declarer(ompl::base::ParamSet& params, std::function<PlannerSettings()> get,
             std::function<void(const PlannerSettings&)> set)
        : params_(params), get_(std::move(get)), set_(std::move(set))
    {
    }

    void number(const std::string& name, unsigned PlannerSettings::*member, const std::string& range)
    {
        declare(
            name, range,
            [name, member](PlannerSettings& settings, const std::string& value)
            { settings.*member = parseUnsigned(name, value, "a whole number, 0 or more"); },
            [member](const PlannerSettings& settings) { return std::to_string(settings.*member); });
    }

    void number(const std::string& name, double PlannerSettings::*member, const std::string& range)
    {
        declare(
            name, range,
            [name, member](PlannerSettings& settings, const std::string& value)
            { settings.*member = parseDouble(name, value, "a number"); },
            [member](const PlannerSettings& settings) { return text(settings.*member); });
    }

    void flag(const std::string& name, bool PlannerSettings::*member)
    {
        declare(
            name, "0,1",
            [name, member](PlannerSettings& settings, const std::string& value)
            { settings.*member = parseBool(name, value); },
            [member](const PlannerSettings& settings) { return settings.*member ? "1" : "0"; });
    }

    void choice(const std::string& name, std::string PlannerSettings::*member, const std::string& range)
    {
        declare(
            name, range, [member](PlannerSettings& settings, const std::string& value) { settings.*member = value; },
            [member](const PlannerSettings& settings) { return settings.*member; });
    }

    void declare(const std::string& name, const std::string& range,
                 const std::function<void(PlannerSettings&, const std::string&)>& read,
                 const std::function<std::string(const PlannerSettings&)>& write)
    {
        params_.declareParam<std::string>(
            name,
            [get = get_, set = set_, read](const std::string& value)
            {
                PlannerSettings settings = get();
                read(settings, value);
                set(settings);
            },
            [get = get_, write] { return write(get()); });
        params_[name].setRangeSuggestion(range);
    }

private:
    ompl::base::ParamSet& params_;
    std::function<PlannerSettings()> get_;
    std::function<void(const PlannerSettings&)> set_;
};
}  // namespace

void validate(const PlannerSettings& settings)
{
    requireRange("num_threads", settings.numThreads, 0, kMaxThreads, true);
    requireOneOf("speculation_policy", settings.speculationPolicy, speculationPolicies());
    requireOneOf("predictor", settings.predictor, predictors());
    requireRange("lookahead", settings.lookahead, 1, kMaxLookahead, false);
    requireOneOf("evaluation", settings.evaluation, evaluations());
    requireRange("weight", settings.weight, 1, kMaxWeight, true);
    requireRange("resolution", settings.resolution, kMinResolution, 1, true);
    for (const double spacing : settings.spacing)
        if (!(spacing > 0.0 && spacing <= kMaxSpacing))
            refuse("spacing", kSpacingExpected, text(spacing));
    requireRange("connectivity", settings.connectivity, 1, kMaxConnectivity, true);
    if (settings.executor != "threads" && settings.executor != "virtual")
        refuse("executor", "threads or virtual", settings.executor);
    requireRange("virtual_check_cost", settings.virtualCheckCost, 0, kMaxVirtualCost, false);
}

void declareParameters(ompl::base::ParamSet& params, std::function<PlannerSettings()> get,
                       std::function<void(const PlannerSettings&)> set)
{
    Declarer declarer(params, std::move(get), std::move(set));
    declarer.number("num_threads", &PlannerSettings::numThreads, "0:1:4096");
    declarer.choice("speculation_policy", &PlannerSettings::speculationPolicy, joined(speculationPolicies()));
    declarer.choice("predictor", &PlannerSettings::predictor, joined(predictors()));
    declarer.number("lookahead", &PlannerSettings::lookahead, "1:1:1000");
    declarer.flag("barrier", &PlannerSettings::barrier);
    declarer.choice("evaluation", &PlannerSettings::evaluation, joined(evaluations()));
    declarer.number("weight", &PlannerSettings::weight, "0.:.1:1000000000.");
    declarer.flag("anytime", &PlannerSettings::anytime);
    declarer.flag("stop_at_first_path", &PlannerSettings::stopAtFirstPath);
    declarer.number("resolution", &PlannerSettings::resolution, "0.:.001:1.");
    declarer.declare(
        "spacing", "",
        [](PlannerSettings& settings, const std::string& value) { settings.spacing = parseSpacing(value); },
        [](const PlannerSettings& settings) { return spacingText(settings.spacing); });
    declarer.number("connectivity", &PlannerSettings::connectivity, "0:1:1000");
    declarer.flag("corner_cutting", &PlannerSettings::cornerCutting);
    declarer.flag("objective_in_checks", &PlannerSettings::objectiveInChecks);
    declarer.choice("executor", &PlannerSettings::executor, "threads,virtual");
    declarer.number("virtual_check_cost", &PlannerSettings::virtualCheckCost, "0.:.001:1000000.");
    declarer.flag("rethrow_exceptions", &PlannerSettings::rethrowExceptions);
}
}  // namespace specplan::planner
