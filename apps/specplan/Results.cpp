// SPDX-License-Identifier: BSD-3-Clause
#include "Results.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <utility>

#include "Outputs.h"
#include "Text.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
using problems::concat;

namespace
{
/// 16 hexadecimal digits: JSON's numbers are too short.
std::string hashText(std::uint64_t hash)
{
    std::ostringstream text;
    text << std::hex << std::setw(16) << std::setfill('0') << hash;
    return text.str();
}

/// Whether SpeculativeAStar planned: of others there is no more than status, cost and time.
bool isOurs(const Run& run)
{
    return run.plannerName == "SpeculativeAStar";
}

std::string percent(double share)
{
    return fixed(100.0 * share, 1) + " %";
}

std::string timesText(unsigned count)
{
    return count == 1 ? "once" : concat(count, " times");
}

std::string policyText(const Run& run)
{
    return run.report.threads == 1 ? "sequential" : run.settings.speculationPolicy;
}

std::string csvField(const nlohmann::ordered_json& value)
{
    if (!value.is_string())
        return value.is_number_float() && !std::isfinite(value.get<double>()) ? "" : value.dump();
    std::string text = value.get<std::string>();
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '"');
    return concat('"', text, '"');
}

struct Column
{
    const char* name;
    int width;
};

constexpr std::array<Column, 10> kColumns{{{"policy", 11},
                                           {"threads", 8},
                                           {"status", 11},
                                           {"time", 11},
                                           {"speed-up", 10},
                                           {"efficiency", 12},
                                           {"accuracy", 10},
                                           {"coverage", 10},
                                           {"demanded", 10},
                                           {"ahead", 8}}};

double perExpansion(std::uint64_t count, const SearchReport& report)
{
    return report.expansions == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(report.expansions);
}
}  // namespace

nlohmann::ordered_json toJson(const Run& run)
{
    const SearchReport& report = run.report;
    nlohmann::ordered_json json;
    json["problem"] = run.problem;
    json["status"] = report.status;
    json["cost"] = report.cost;
    if (!isOurs(run))
    {
        json["wall_time_s"] = report.wallTime;
        json["planner"] = run.plannerName;
        return json;
    }
    json["refinements"] = report.refinements;
    json["expansions"] = report.expansions;
    json["checks_used"] = report.checksUsed;
    json["checks_total"] = report.checksTotal;
    json["speculative_checks"] = report.speculativeChecks - report.speculativeDropped;
    json["speculative_used"] = report.speculativeUsed;
    json["accuracy"] = report.accuracy;
    json["coverage"] = report.coverage;
    json["timeliness"] = report.timeliness;
    json["wall_time_s"] = report.wallTime;
    json["search_time_s"] = report.searchTime;
    json["wait_time_s"] = report.waitTime;
    json["virtual_time_s"] = report.virtualTime;
    json["sequential_time_s"] = report.sequentialTime;
    json["speedup"] = report.speedup;
    json["efficiency"] = report.efficiency;
    json["threads"] = report.threads;
    json["policy"] = run.settings.speculationPolicy;
    json["weight"] = run.report.weight;
    json["evaluation"] = report.evaluation;
    json["order_hash"] = hashText(report.orderHash);
    json["planner"] = run.plannerName;
    if (!report.advice.empty())
        json["advice"] = report.advice;
    for (const Improvement& improvement : run.improvements)
        json["improvements"].push_back({{"time_s", improvement.seconds}, {"cost", improvement.cost}});
    return json;
}

void printRun(std::ostream& out, const Run& run)
{
    const SearchReport& report = run.report;
    const auto line = [&out](const std::string& name, const std::string& value)
    { out << "  " << std::left << std::setw(20) << name << value << '\n'; };
    out << problems::printable(run.problem) << '\n';
    line("status", report.status + (run.interrupted && run.solved() ? ", interrupted" : ""));
    if (run.solved())
        line("cost", concat(std::setprecision(9), report.cost, ", ", run.path.size(), " states"));
    if (!isOurs(run))
    {
        line("planner", run.plannerName);
        line("time", durationText(report.wallTime));
        return;
    }
    line("search", concat(policyText(run), ", ", report.threads, report.threads == 1 ? " thread" : " threads",
                          ", weight ", run.report.weight,
                          report.refinements > 0 ? concat(", spacing halved ", timesText(report.refinements)) : ""));
    for (const Improvement& improvement : run.improvements)
        line("path",
             concat("cost ", std::setprecision(9), improvement.cost, " after ", durationText(improvement.seconds)));
    line("expansions", concat(report.expansions, ", order ", hashText(report.orderHash)));
    line("checks used", concat(report.checksUsed, " of ", report.checksTotal, " run"));
    if (report.speculativeChecks > 0)
        line("checked ahead",
             concat(report.speculativeChecks - report.speculativeDropped, ": accuracy ", percent(report.accuracy),
                    ", coverage ", percent(report.coverage), ", timeliness ", percent(report.timeliness)));
    line("time", concat(durationText(run.seconds()), run.settings.executor == "virtual" ? " on the virtual clock" : "",
                        ", of it waiting for checks ", durationText(report.waitTime)));
    if (report.threads > 1)
        line("sequential A*", concat(durationText(report.sequentialTime), " by the checks' durations: speed-up ",
                                     fixed(report.speedup, 2), ", efficiency ", percent(report.efficiency)));
}

void Table::printHeading(const Run& run)
{
    out_ << problems::printable(run.problem) << ": " << run.report.expansions << " expansions, "
         << run.report.checksUsed << " checks used, cost "
         << (run.solved() ? concat(std::setprecision(9), run.report.cost) : "-") << '\n';
    for (const Column& column : kColumns)
        out_ << std::right << std::setw(column.width) << column.name;
    out_ << "   (demanded and ahead: checks per expansion)\n";
}

void Table::add(const Run& run)
{
    if (run.problem != problem_)
    {
        problem_ = run.problem;
        printHeading(run);
    }
    const SearchReport& report = run.report;
    const bool ahead = report.speculativeChecks > 0;
    const std::array<std::string, kColumns.size()> cells{
        policyText(run),
        std::to_string(report.threads),
        report.status,
        durationText(run.seconds()),
        fixed(report.speedup, 2),
        percent(report.efficiency),
        ahead ? percent(report.accuracy) : "-",
        ahead ? percent(report.coverage) : "-",
        fixed(perExpansion(report.demandedChecks, report), 2),
        fixed(perExpansion(report.speculativeChecks - report.speculativeDropped, report), 2)};
    for (std::size_t i = 0; i < cells.size(); ++i)
        out_ << std::right << std::setw(kColumns[i].width) << cells[i];
    out_ << '\n';
    requireWritten(out_);  // a series of searches should not go on in vain
}

void writeCsv(std::ostream& out, const std::vector<Run>& runs)
{
    const auto writeRow = [&out](const nlohmann::ordered_json& json, bool keys)
    {
        const char* separator = "";
        for (const auto& item : json.items())
            out << std::exchange(separator, ",") << (keys ? item.key() : csvField(item.value()));
        out << '\n';
    };
    if (!runs.empty())
        writeRow(toJson(runs.front()), true);
    for (const Run& run : runs)
        writeRow(toJson(run), false);
}
}  // namespace specplan::command
