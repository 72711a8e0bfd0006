// SPDX-License-Identifier: BSD-3-Clause
#include "Verify.h"

#include <algorithm>
#include <ostream>

#include "Comparison.h"
#include "Interrupt.h"
#include "Results.h"
#include "Text.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
using problems::concat;

namespace
{
RunRecord recordOf(const Run& run)
{
    RunRecord record{run.report.status, run.stopped, run.report.orderHash, run.order, {}, run.path};
    for (const Improvement& improvement : run.improvements)
        record.costs.push_back(improvement.cost);
    if (record.costs.empty() && run.solved())
        record.costs.push_back(run.report.cost);
    return record;
}

std::size_t comparedExpansions(const Verification& verification, const Run& run)
{
    return std::min(run.order.size(), verification.sequential.order.size());
}

/// What was compared, and with what result.
std::string summary(const Verification& verification, const Run& run)
{
    const std::size_t expansions = comparedExpansions(verification, run);
    if (verification.interrupted)
        return concat("interrupted after ", expansions, " expansions of the sequential run");
    if (!verification.difference.empty())
        return verification.difference;
    if (run.stopped || verification.sequential.stopped)
        return concat("the first ", expansions, " expansions and the paths found in them are those of sequential A*");
    return concat("status, path, cost and all ", expansions, " expansions are those of sequential A*");
}
}  // namespace

Verification verify(const Problem& problem, const CommonOptions& options, const Run& run)
{
    CommonOptions unlimited = options;
    unlimited.timeLimit = std::chrono::hours(24 * 365);
    PlannerSettings settings = options.planner;
    settings.numThreads = 1;
    settings.speculationPolicy = "none";
    // One more than the other had shows that it goes on.
    const std::uint64_t most = run.order.size() + (run.stopped ? 0 : 1);
    Verification verification;
    verification.sequential.stopped = true;
    if (most > 0 && !interrupted())
        verification.sequential = planOnce(problem, unlimited, settings, {.order = true, .expansions = most});
    verification.interrupted = interrupted() && verification.sequential.order.size() < run.order.size();
    verification.difference = differenceOf(recordOf(run), recordOf(verification.sequential));
    return verification;
}

nlohmann::ordered_json toJson(const Verification& verification, const Run& run)
{
    const Run& sequential = verification.sequential;
    const bool part = run.stopped || sequential.stopped;
    nlohmann::ordered_json json{{"same", verification.difference.empty() && !verification.interrupted},
                                {"compared", part ? "first expansions" : "all"},
                                {"expansions", comparedExpansions(verification, run)},
                                {"summary", summary(verification, run)}};
    json["sequential"] = toJson(sequential);
    return json;
}

void printVerification(std::ostream& out, const Verification& verification, const Run& run)
{
    out << "  verified            " << (verification.difference.empty() ? "" : "NOT THE SAME: ")
        << summary(verification, run) << " (" << durationText(verification.sequential.seconds()) << ")\n";
}
}  // namespace specplan::command
