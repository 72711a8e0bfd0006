// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>

#include "specplan/problems/InputError.h"

namespace specplan::command
{
using problems::concat;

namespace
{
/// Index of the first difference within what both have; their common length if there is none.
template <typename T>
std::size_t firstDifference(const std::vector<T>& a, const std::vector<T>& b)
{
    const std::size_t both = std::min(a.size(), b.size());
    const auto end = a.begin() + static_cast<std::ptrdiff_t>(both);
    return static_cast<std::size_t>(std::mismatch(a.begin(), end, b.begin()).first - a.begin());
}

/// Of runs that nothing stopped, and whose expansions and costs agree as far as both have any.
std::string differenceOfEnds(const RunRecord& run, const RunRecord& sequential)
{
    if (run.status != sequential.status)
        return concat("its status is ", run.status, ", that of the sequential run ", sequential.status);
    if (run.costs.size() != sequential.costs.size())
        return concat("it found ", run.costs.size(), " paths, the sequential run ", sequential.costs.size());
    if (run.orderHash != sequential.orderHash)
        return "its order hash is not that of the sequential run";
    if (run.path != sequential.path)
        return "its path is not that of the sequential run";
    return {};
}
}  // namespace

std::string differenceOf(const RunRecord& run, const RunRecord& sequential)
{
    const std::size_t same = firstDifference(run.expansions, sequential.expansions);
    if (same < std::min(run.expansions.size(), sequential.expansions.size()))
        return concat("its expansion ", same + 1, " is not that of the sequential run");
    if (!run.stopped && sequential.expansions.size() > same)
        return concat("it ended after ", same, " expansions, and the sequential run went on");
    if (!sequential.stopped && run.expansions.size() > same)
        return concat("the sequential run ended after ", same, " expansions, and it went on");
    const std::size_t paths = firstDifference(run.costs, sequential.costs);
    if (paths < std::min(run.costs.size(), sequential.costs.size()))
        return concat("its path ", paths + 1, " costs ", std::setprecision(17), run.costs[paths],
                      ", that of the sequential run ", sequential.costs[paths]);
    return run.stopped || sequential.stopped ? std::string() : differenceOfEnds(run, sequential);
}
}  // namespace specplan::command
