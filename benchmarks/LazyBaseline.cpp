// SPDX-License-Identifier: BSD-3-Clause
#include "LazyBaseline.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <vector>

namespace specplan::benchmarks
{
namespace
{
using lattice::CheckId;
using lattice::NodeId;

struct Way
{
    double f;
    double g;
    double motion;  ///< cost of the last motion
    std::uint64_t age;
    NodeId node;
    std::vector<CheckId> inner;

    [[nodiscard]] bool operator>(const Way& other) const
    {
        return std::tuple(f, -g, motion, age) > std::tuple(other.f, -other.g, other.motion, other.age);
    }
};

/// Runs each check once.
class Verdicts
{
public:
    explicit Verdicts(validity::Checker& checker) : checker_(checker)
    {
    }

    bool operator()(CheckId check)
    {
        const auto [place, isNew] = known_.try_emplace(check, false);
        if (isNew)
            place->second = checker_.check(check, 0);
        return place->second;
    }

    void enter(CheckId check, bool valid)
    {
        known_[check] = valid;
    }

    [[nodiscard]] std::uint64_t count() const
    {
        return known_.size();
    }

private:
    validity::Checker& checker_;
    std::map<CheckId, bool> known_;
};
}  // namespace

BaselineResult lazyAStar(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, validity::Checker& checker,
                         NodeId start, NodeId goal, double weight)
{
    std::priority_queue<Way, std::vector<Way>, std::greater<>> open;
    std::vector<bool> closed;
    Verdicts isValid(checker);
    lattice::Successors successors;
    std::uint64_t age = 0;
    isValid.enter(CheckId::ofState(start), true);
    open.push({weight * heuristic.estimate(start), 0.0, 0.0, age++, start, {}});
    while (!open.empty())
    {
        const Way way = open.top();
        open.pop();
        closed.resize(std::max<std::size_t>(closed.size(), lattice.size()));
        if (closed[way.node] || !isValid(CheckId::ofState(way.node)) ||
            !std::ranges::all_of(way.inner, std::ref(isValid)))
            continue;
        closed[way.node] = true;
        if (way.node == goal)
            return {isValid.count() - 1, way.g};
        lattice.successors(way.node, successors);
        closed.resize(std::max<std::size_t>(closed.size(), lattice.size()));
        for (const lattice::Successors::Edge& edge : successors.edges)
        {
            const auto inner = successors.innerOf(edge);
            if (!closed[edge.node])
                open.push({way.g + edge.cost + weight * heuristic.estimate(edge.node),
                           way.g + edge.cost,
                           edge.cost,
                           age++,
                           edge.node,
                           {inner.begin(), inner.end()}});
        }
    }
    return {isValid.count() - 1, 0.0};
}
}  // namespace specplan::benchmarks
