// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/Explanation.h"

#include <algorithm>
#include <cmath>

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
/// What can be told from the steps out of one node.
struct Branching
{
    std::size_t steps = 0;
    std::size_t checked = 0;  ///< of these, whose inside is checked
    std::size_t guarded = 0;  ///< of these, that need other states beside them to be valid
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    unsigned mostStates = 0;  ///< inside one motion
    double states = 0.0;      ///< inside all of these motions
};

Branching branchingAt(const LatticeQuery& query, lattice::NodeId node, const ob::SpaceInformation& si)
{
    Branching branching;
    lattice::Successors successors;
    query.successors(node, successors);
    const StateHandle from = query.stateOf(node);
    for (const lattice::Successors::Edge& edge : successors.edges)
    {
        const StateHandle to = query.stateOf(edge.node);
        const double length = si.distance(from.get(), to.get());
        const bool checked = successors.motionOf(edge).has_value();
        const unsigned states = checked ? query.embedding().segments(from.get(), to.get()) - 1 : 0;
        ++branching.steps;
        branching.checked += checked ? 1 : 0;
        branching.guarded += successors.guardsOf(edge).empty() ? 0 : 1;
        branching.shortest = std::min(branching.shortest, length);
        branching.longest = std::max(branching.longest, length);
        branching.mostStates = std::max(branching.mostStates, states);
        branching.states += states;
    }
    return branching;
}
}  // namespace

void explain(const PlannerSession& session, const std::string& refusal, std::ostream& out)
{
    if (!session.query)
    {
        out << "There is nothing to search: " << refusal << '\n';
        return;
    }
    const LatticeQuery& query = *session.query;
    const Embedding& embedding = query.embedding();
    out << "Lattice over " << session.si->getStateSpace()->getName() << ", " << embedding.axes() << " axes:\n";
    embedding.describe(out);
    out << "  " << embedding.nodes() << " states in all, inside the bounds or nearly so\n";
    if (embedding.isCoarse())
        out << "  with twice the usual spacing, for a first path\n";
    if (!embedding.sumsDistances())
        out << "  the space measures distances in a way of its own: steps cost what it says\n";
    const Branching branching = branchingAt(query, query.starts().front(), *session.si);
    out << "From the first start: " << branching.steps << " motions";
    if (branching.steps > 0)
        out << " of length " << branching.shortest << " to " << branching.longest << ", " << branching.checked
            << " of them checked inside";
    if (branching.checked > 0)
        out << " (" << branching.states / static_cast<double>(branching.checked) << " states on average, "
            << branching.mostStates << " at most)";
    if (branching.guarded > 0)
        out << ", " << branching.guarded << " past corners that have to be valid";
    out << "\nSearch: " << (query.isLazy() ? "lazy, " : "") << "weight " << session.weight() << ", "
        << (query.addsCosts() ? "costs add up" : "costs are combined by the objective; weights have no meaning") << ", "
        << (query.isConsistent() ? "consistent heuristic" : "states are opened again where they are reached better")
        << '\n';
    out << "Starts: " << query.starts().size() << ". Goals: " << query.goals().size() << " states";
    std::size_t joined = 0;
    for (const lattice::NodeId goal : query.goals())
        joined += query.lattice().isTerminal(goal) ? 1 : 0;
    if (joined > 0)
        out << ", " << joined << " of them off the lattice, joined by final motions";
    if (query.takesRegion())
        out << "; every state that satisfies the goal ends the search";
    out << ".\n";
    if (!refusal.empty())
        out << "There is nothing to search: " << refusal << '\n';
}

void describeRun(const SearchReport& report, std::map<std::string, std::string>& properties)
{
    const auto number = [&](const char* name, double value) { properties[name] = std::to_string(value); };
    const auto count = [&](const char* name, std::uint64_t value) { properties[name] = std::to_string(value); };
    count("checks used INTEGER", report.checksUsed);
    count("checks run INTEGER", report.checksTotal);
    count("checks reused INTEGER", report.checksReused);
    count("speculative checks INTEGER", report.speculativeChecks);
    count("expansions INTEGER", report.expansions);
    count("lattice nodes INTEGER", report.nodes);
    count("refinements INTEGER", report.refinements);
    number("speculation accuracy REAL", report.accuracy);
    number("speculation coverage REAL", report.coverage);
    number("time waited for checks REAL", report.waitTime);
    number("suboptimality bound REAL", report.bound);
}
}  // namespace specplan::planner
