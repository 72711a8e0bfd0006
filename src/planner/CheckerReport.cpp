// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/CheckerReport.h"

#include <algorithm>
#include <ostream>

namespace specplan
{
bool CheckerReport::isError(Kind kind) noexcept
{
    return kind != Kind::WritesBesideValues && kind != Kind::Slow && kind != Kind::TimeLimit;
}

bool CheckerReport::passed() const noexcept
{
    return std::ranges::none_of(findings, [](const Finding& finding) { return isError(finding.kind); });
}

bool CheckerReport::has(Kind kind) const noexcept
{
    return std::ranges::any_of(findings, [kind](const Finding& finding) { return finding.kind == kind; });
}

std::ostream& operator<<(std::ostream& out, const CheckerReport& report)
{
    out << "checker test: " << (report.passed() ? "passed" : "failed") << ", " << report.states << " states, "
        << report.validStates << " of them valid, " << report.calls << " calls, up to " << report.threads
        << " at once; a call takes " << report.medianSeconds * 1e6 << " us (median), at most "
        << report.slowestSeconds * 1e6 << " us\n";
    for (const CheckerReport::Finding& finding : report.findings)
        out << (CheckerReport::isError(finding.kind) ? "error: " : "note: ") << finding.text << '\n';
    return out;
}
}  // namespace specplan
