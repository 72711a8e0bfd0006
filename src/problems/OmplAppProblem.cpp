// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/OmplAppProblem.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "specplan/problems/ConfigFile.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/PlannerCatalog.h"
#include "specplan/problems/TextFile.h"

namespace specplan::problems
{
namespace
{
constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

std::string lowered(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The entries of one file by full name ("problem.start.x"); each is taken once, and what is left over is unknown.
class Entries
{
public:
    Entries(const std::string& path, const std::vector<ConfigEntry>& entries) : path_(path)
    {
        for (const ConfigEntry& entry : entries)
        {
            const std::string name = entry.section + '.' + entry.key;
            const auto [there, isNew] = entries_.emplace(name, entry);
            if (!isNew)
                throw InputError(path_, entry.line,
                                 concat("expected ", name, " once, but line ", there->second.line, " has it too"));
        }
    }

    [[nodiscard]] bool has(const std::string& name) const
    {
        return entries_.contains(name);
    }

    [[nodiscard]] std::optional<ConfigEntry> take(const std::string& name)
    {
        const auto found = entries_.find(name);
        if (found == entries_.end())
            return std::nullopt;
        ConfigEntry entry = found->second;
        entries_.erase(found);
        return entry;
    }

    [[nodiscard]] ConfigEntry require(const std::string& name, const std::string& meaning)
    {
        auto entry = take(name);
        if (!entry)
            throw InputError(path_, 0, concat("expected ", name, ", ", meaning, ", found none"));
        return *std::move(entry);
    }

    [[nodiscard]] double number(const ConfigEntry& entry) const
    {
        double value = 0.0;
        if (!parse(entry.value, value))
            fail(entry, "a number");
        return value;
    }

    /// A number within a range, both ends included.
    [[nodiscard]] std::optional<double> takeNumber(const std::string& name, double low, double high)
    {
        const auto entry = take(name);
        if (!entry)
            return std::nullopt;
        const double value = number(*entry);
        if (value < low || value > high)
            fail(*entry, concat("a number from ", low, " to ", high));
        return value;
    }

    [[noreturn]] void fail(const ConfigEntry& entry, const std::string& expected) const
    {
        throw InputError(
            path_, entry.line,
            concat(entry.section, '.', entry.key, ": expected ", expected, ", found ", inQuotes(entry.value)));
    }

    [[nodiscard]] const std::map<std::string, ConfigEntry>& left() const noexcept
    {
        return entries_;
    }

private:
    const std::string& path_;
    std::map<std::string, ConfigEntry> entries_;
};

class Reader
{
public:
    Reader(OmplAppProblem& problem, const std::vector<ConfigEntry>& entries)
        : problem_(problem), entries_(problem.file, settingsOf(entries))
    {
    }

    void read()
    {
        refuseControls();
        if (const auto name = entries_.take("problem.name"))
            problem_.name = name->value;
        problem_.robot = bodyFile("robot", "a mesh file");
        problem_.world = bodyFile("world", "a mesh file or OctoMap");
        problem_.planar = isPlanar();
        problem_.start = pose("start");
        problem_.goal = pose("goal");
        problem_.goalThreshold = entries_.takeNumber("problem.threshold", 0.0, 1e300).value_or(1e-6);
        problem_.volume = volume();
        readObjective();
        problem_.longestValidSegmentFraction =
            entries_.takeNumber("problem.longest_valid_segment_fraction", 1e-9, 0.999);
        problem_.timeLimit = entries_.takeNumber("benchmark.time_limit", 1e-3, 1e9);
        problem_.memoryLimit = entries_.takeNumber("benchmark.mem_limit", 1.0, 1e9);
        if (const auto count = entries_.take("benchmark.run_count"))
            problem_.runCount = runs(*count);
        warnOfTheRest();
    }

private:
    /// All but the planner section, which is a list and read apart.
    static std::vector<ConfigEntry> settingsOf(const std::vector<ConfigEntry>& entries)
    {
        std::vector<ConfigEntry> settings;
        std::ranges::copy_if(entries, std::back_inserter(settings),
                             [](const ConfigEntry& entry) { return entry.section != "planner"; });
        return settings;
    }

    void refuseControls()
    {
        if (const auto control = entries_.take("problem.control"))
            throw InputError(problem_.file, control->line,
                             concat("problem.control: problems with controls (", inQuotes(control->value),
                                    ") are not supported; expected a rigid body that moves freely"));
    }

    NamedFile bodyFile(const std::string& what, const std::string& kind)
    {
        const ConfigEntry entry = entries_.require("problem." + what, kind);
        if (entry.value.empty())
            entries_.fail(entry, kind);
        const std::filesystem::path path = std::filesystem::path(problem_.file).parent_path() / entry.value;
        if (!std::filesystem::exists(path))
            entries_.fail(entry, kind + " relative to the folder of this file");
        return {path.string(), entry.line};
    }

    /// As in OMPL.app: a pose without height and axis is one in the plane.
    bool isPlanar() const
    {
        for (const char* which : {"problem.start.", "problem.goal."})
            for (const char* key : {"z", "axis.x", "axis.y", "axis.z"})
                if (entries_.has(std::string(which) + key))
                    return false;
        return true;
    }

    RigidPose pose(const std::string& which)
    {
        const std::string prefix = "problem." + which + '.';
        RigidPose pose;
        for (std::size_t i = 0; i < (problem_.planar ? 2U : 3U); ++i)
        {
            const ConfigEntry entry = entries_.require(prefix + kAxes[i], "a number");
            pose.position[i] = entries_.number(entry);
            pose.line = std::max(pose.line, entry.line);
        }
        pose.angle = entries_.number(entries_.require(prefix + "theta", "an angle in radians"));
        if (problem_.planar)
            return pose;
        double length = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const ConfigEntry entry = entries_.require(prefix + "axis." + kAxes[i], "a number");
            pose.axis[i] = entries_.number(entry);
            length = std::max(length, std::abs(pose.axis[i]));
        }
        if (length < 1e-9 && pose.angle != 0.0)
            throw InputError(problem_.file, pose.line, concat(prefix, "axis: expected an axis longer than 0"));
        if (length < 1e-9)
            pose.axis = {0.0, 0.0, 1.0};
        return pose;
    }

    std::optional<RigidVolume> volume()
    {
        const std::size_t dimension = problem_.planar ? 2 : 3;
        RigidVolume volume;
        std::vector<std::string> missing;
        for (std::size_t i = 0; i < dimension; ++i)
            for (const bool high : {false, true})
            {
                const std::string name = concat("problem.volume.", high ? "max." : "min.", kAxes[i]);
                const auto entry = entries_.take(name);
                if (!entry)
                {
                    missing.push_back(name);
                    continue;
                }
                (high ? volume.high : volume.low)[i] = entries_.number(*entry);
                volume.line = std::max(volume.line, entry->line);
            }
        if (missing.size() == 2 * dimension)
            return std::nullopt;
        if (!missing.empty())
            throw InputError(problem_.file, volume.line,
                             concat("expected all sides of the volume or none, but ", missing.front(), " is missing"));
        for (std::size_t i = 0; i < dimension; ++i)
            if (volume.low[i] >= volume.high[i])
                throw InputError(problem_.file, volume.line,
                                 concat("expected problem.volume.min.", kAxes[i], " below problem.volume.max.",
                                        kAxes[i], ", found ", volume.low[i], " and ", volume.high[i]));
        return volume;
    }

    void readObjective()
    {
        // OMPL.app looks at the beginning only.
        if (const auto entry = entries_.take("problem.objective"))
        {
            if (entry->value.starts_with("length"))
                problem_.objective = RigidObjective::Length;
            else if (entry->value.starts_with("max_min_clearance"))
                problem_.objective = RigidObjective::MaxMinClearance;
            else if (entry->value.starts_with("mechanical_work"))
                problem_.objective = RigidObjective::MechanicalWork;
            else
                entries_.fail(*entry, "length, max_min_clearance or mechanical_work");
        }
        problem_.objectiveThreshold = entries_.takeNumber("problem.objective.threshold", -1e300, 1e300);
    }

    unsigned runs(const ConfigEntry& entry) const
    {
        int count = 0;
        if (!parse(entry.value, count) || count < 1)
            entries_.fail(entry, "a whole number from 1");
        return static_cast<unsigned>(count);
    }

    void warnOfTheRest()
    {
        std::vector<const ConfigEntry*> left;
        for (const auto& [name, entry] : entries_.left())
            left.push_back(&entry);
        std::ranges::sort(left, {}, &ConfigEntry::line);
        for (const ConfigEntry* entry : left)
        {
            const bool known = entry->section == "problem" || entry->section == "benchmark";
            warn(entry->line,
                 known ? concat(entry->section, '.', entry->key, " is not known and not heeded")
                       : concat("section [", entry->section, "] is not known: ", entry->key, " is not heeded"));
        }
    }

    void warn(std::size_t line, const std::string& text)
    {
        problem_.warnings.push_back(printable(concat(problem_.file, ':', line, ": ", text)));
    }

    OmplAppProblem& problem_;
    Entries entries_;
};

/// Reads the planner section: "rrt =" asks for a planner, "rrt.range = 5" sets a parameter of the last one of that name
/// and asks for it if there is none.
void readPlanners(OmplAppProblem& problem, const std::vector<ConfigEntry>& entries)
{
    const auto warn = [&problem](const ConfigEntry& entry, const std::string& text)
    { problem.warnings.push_back(printable(concat(problem.file, ':', entry.line, ": ", text))); };
    for (const ConfigEntry& entry : entries)
    {
        if (entry.section != "planner")
            continue;
        const std::size_t dot = entry.key.find('.');
        const std::string name = entry.key.substr(0, dot);
        if (lowered(name) == "problem")
            warn(entry, concat("planner.", entry.key, " is not known and not heeded"));
        else if (!isPlannerName(name))
            warn(entry, concat("planner ", inQuotes(name), " is not known and left out"));
        else if (dot == std::string::npos)
        {
            problem.planners.push_back({name, {}, entry.line});
            if (!entry.value.empty())
                warn(entry,
                     concat("planner.", entry.key, " takes no value: ", inQuotes(entry.value), " is not heeded"));
        }
        else
        {
            const auto last = std::ranges::find(problem.planners.rbegin(), problem.planners.rend(), lowered(name),
                                                [](const PlannerRequest& request) { return lowered(request.name); });
            PlannerRequest& request = last != problem.planners.rend()
                                          ? *last
                                          : problem.planners.emplace_back(PlannerRequest{name, {}, entry.line});
            request.parameters[entry.key.substr(dot + 1)] = entry.value;
        }
    }
}
}  // namespace

OmplAppProblem readOmplAppProblem(const std::string& path)
{
    return parseOmplAppProblem(readText(path), path);
}

OmplAppProblem parseOmplAppProblem(std::string text, const std::string& name)
{
    const std::vector<ConfigEntry> entries = parseConfig(std::move(text), name);
    OmplAppProblem problem;
    problem.file = name;
    problem.name = std::filesystem::path(name).stem().string();
    Reader(problem, entries).read();
    readPlanners(problem, entries);
    return problem;
}
}  // namespace specplan::problems
