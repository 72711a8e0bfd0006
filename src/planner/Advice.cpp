// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/Advice.h"

#include <algorithm>
#include <sstream>

namespace specplan::planner
{
namespace
{
/// A search that has expanded less than this share of its lattice was far from its end.
constexpr double kSmallShare = 0.2;

/// Where checks take at least this share of the time, more threads help.
constexpr double kMostlyChecks = 0.5;

bool chosenByUser(const PlannerSettings& settings)
{
    return settings.resolution > 0.0 || !settings.spacing.empty();
}
}  // namespace

std::string describe(const LatticeSearchReport& search)
{
    std::ostringstream out;
    out << "spacing x " << search.spacing << ", weight " << search.weight << ": " << search.end << ", "
        << search.expansions << " expansions on about " << search.states << " states, " << search.checksUsed
        << " checks";
    return out.str();
}

std::string advise(const SearchReport& report, const PlannerSettings& settings, bool canBeLazy, unsigned processors)
{
    if (report.searches.empty())
        return "";
    const LatticeSearchReport& last = report.searches.back();
    std::ostringstream out;
    const bool exhausted = last.end == "no path";
    if (exhausted)
    {
        out << (chosenByUser(settings) ? "Try a smaller spacing, or none, so that the planner may refine it. "
                : settings.anytime     ? "Try a spacing smaller than the narrowest passage. "
                                       : "Set anytime to 1, so that the planner may go on with finer lattices. ");
        return out.str() + "A longer time limit does not help.";
    }
    if (last.weight < 2.0)
        out << "A weight of 3 or more finds a first path sooner. ";
    if (settings.evaluation == "eager" && canBeLazy)
        out << "Lazy evaluation (evaluation) needs fewer checks. ";
    if (static_cast<double>(last.expansions) < kSmallShare * last.states && chosenByUser(settings))
        out << "A larger spacing makes a smaller lattice. ";
    if (report.threads < processors && report.waitTime > kMostlyChecks * report.wallTime)
        out << "More threads (num_threads) share the checks: " << processors << " processors are there. ";
    const bool coarserExhausted =
        std::ranges::any_of(report.searches, [](const LatticeSearchReport& search) { return search.end == "no path"; });
    if (coarserExhausted)
        out << "Coarser lattices have no path: passages are narrow, and finer lattices take longer. ";
    out << "Otherwise: a longer time limit.";
    return out.str();
}
}  // namespace specplan::planner
