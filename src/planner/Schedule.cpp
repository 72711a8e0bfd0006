// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/Schedule.h"

#include <algorithm>

#include "specplan/planner/spaces/Components.h"

namespace specplan::planner
{
namespace
{
/// The part of a weight that is above 1 is divided by this for a better path.
constexpr double kHaste = 3.0;

/// Below this a weight is 1.
constexpr double kLeastWeight = 1.05;

/// Weight of the second search on a small coarse lattice, where most is known by then.
constexpr double kSecondWeight = 2.0;

/// Checks that a first path may take on the usual lattice over many axes before the coarse one is tried, and those that
/// this one may take.
constexpr std::uint64_t kUsualPatience = 4000;
constexpr std::uint64_t kCoarsePatience = 16000;

double smaller(double weight)
{
    const double next = 1.0 + (weight - 1.0) / kHaste;
    return next < kLeastWeight ? 1.0 : next;
}
}  // namespace

Schedule::Schedule(const Terms& terms) : terms_(terms)
{
    current_.weight = terms.weight;
    if (terms.coarsens && terms.axes > kFewAxes)
        current_.patience = kUsualPatience;
    else if (terms.coarsens && terms.automatic)
        coarsen(terms.weight);
}

const Schedule::Search& Schedule::next(End end)
{
    if (end == End::Solved)
        afterPath();
    else if (end == End::GivenUp && !coarse_)
        coarsen(current_.weight);
    else
        refine(current_.weight);
    return current_;
}

void Schedule::afterPath()
{
    if (!coarse_ && terms_.weighted && current_.weight > 1.0)
        current_ = {smaller(current_.weight)};
    else if (!coarse_)
        refine(current_.weight);
    else if (!terms_.automatic || !terms_.weighted)
        refine(terms_.weight);  // what was asked for is the bound on the usual lattice
    else if (terms_.axes <= kFewAxes && current_.weight > kSecondWeight)
        current_ = {kSecondWeight, Change::None, kCoarsePatience};
    else
        refine(std::min(current_.weight, smaller(terms_.weight)));
}

void Schedule::coarsen(double weight)
{
    current_ = {weight, Change::Coarsen, kCoarsePatience};
    coarse_ = true;
}

void Schedule::refine(double weight)
{
    current_ = {weight, Change::Refine, kEndless};
    coarse_ = false;
}
}  // namespace specplan::planner
