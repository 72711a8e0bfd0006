// SPDX-License-Identifier: BSD-3-Clause
// Which search follows which.
#include <gtest/gtest.h>

#include <tuple>
#include <vector>

#include "specplan/planner/Schedule.h"

namespace specplan::test
{
namespace
{
using planner::Schedule;
using Change = Schedule::Change;
using End = Schedule::End;

constexpr std::uint64_t kEndless = Schedule::kEndless;

Schedule::Terms termsFor(unsigned axes, double weight = 10.0)
{
    Schedule::Terms terms;
    terms.weight = weight;
    terms.coarsens = true;
    terms.axes = axes;
    return terms;
}

/// What the schedule does, search after search, where each ends as told.
using Steps = std::vector<std::tuple<double, Change, bool>>;

Steps stepsOf(Schedule schedule, const std::vector<End>& ends)
{
    Steps steps{{schedule.current().weight, schedule.current().change, schedule.isCoarse()}};
    for (const End end : ends)
    {
        const Schedule::Search& next = schedule.next(end);
        steps.emplace_back(next.weight, next.change, schedule.isCoarse());
    }
    return steps;
}

TEST(ScheduleOfSearches, WithFewAxesTheCoarseLatticeComesFirst)
{
    const Steps steps = stepsOf(Schedule(termsFor(3)), std::vector<End>(6, End::Solved));
    EXPECT_EQ(steps, (Steps{{10.0, Change::Coarsen, true},
                            {2.0, Change::None, true},
                            {2.0, Change::Refine, false},
                            {1.0 + 1.0 / 3.0, Change::None, false},
                            {1.0 + 1.0 / 3.0 / 3.0, Change::None, false},
                            {1.0, Change::None, false},
                            {1.0, Change::Refine, false}}));
}

TEST(ScheduleOfSearches, WithoutAPathThereTheUsualLatticeIsSearchedInTheSameHaste)
{
    for (const End end : {End::Infeasible, End::GivenUp})
    {
        Schedule schedule(termsFor(2));
        EXPECT_LT(schedule.current().patience, kEndless);
        EXPECT_EQ(schedule.next(end).weight, 10.0);
        EXPECT_EQ(schedule.current().change, Change::Refine);
        EXPECT_EQ(schedule.current().patience, kEndless);
        EXPECT_FALSE(schedule.isCoarse());
        EXPECT_EQ(schedule.next(End::Solved).weight, 4.0);
    }
}

TEST(ScheduleOfSearches, WithManyAxesTheCoarseLatticeIsForSearchesThatTakeLong)
{
    Schedule quick(termsFor(6));
    EXPECT_FALSE(quick.isCoarse());
    EXPECT_LT(quick.current().patience, kEndless);
    EXPECT_EQ(quick.next(End::Solved).weight, 4.0);
    EXPECT_EQ(quick.current().patience, kEndless);

    const Steps slow = stepsOf(Schedule(termsFor(6)), {End::GivenUp, End::Solved, End::Solved});
    EXPECT_EQ(slow, (Steps{{10.0, Change::None, false},
                           {10.0, Change::Coarsen, true},
                           {4.0, Change::Refine, false},
                           {2.0, Change::None, false}}));

    const Steps vain = stepsOf(Schedule(termsFor(6)), {End::GivenUp, End::GivenUp, End::Solved});
    EXPECT_EQ(vain, (Steps{{10.0, Change::None, false},
                           {10.0, Change::Coarsen, true},
                           {10.0, Change::Refine, false},
                           {4.0, Change::None, false}}));
}

TEST(ScheduleOfSearches, AWeightThatWasAskedForIsKeptOnTheUsualLattice)
{
    Schedule::Terms few = termsFor(2, 5.0);
    few.automatic = false;
    EXPECT_EQ(stepsOf(Schedule(few), {}), (Steps{{5.0, Change::None, false}})) << "the bound is for the usual lattice";
    Schedule::Terms many = termsFor(6, 5.0);
    many.automatic = false;
    EXPECT_EQ(stepsOf(Schedule(many), {End::GivenUp, End::Solved}),
              (Steps{{5.0, Change::None, false}, {5.0, Change::Coarsen, true}, {5.0, Change::Refine, false}}));
}

TEST(ScheduleOfSearches, WithoutWeightsOnlyLatticesChange)
{
    Schedule::Terms terms = termsFor(3, 1.0);
    terms.weighted = false;
    EXPECT_EQ(stepsOf(Schedule(terms), {End::Solved, End::Solved, End::Solved}), (Steps{{1.0, Change::Coarsen, true},
                                                                                        {1.0, Change::Refine, false},
                                                                                        {1.0, Change::Refine, false},
                                                                                        {1.0, Change::Refine, false}}));
}

TEST(ScheduleOfSearches, ALatticeThatCannotBeCoarseIsRefinedWhereItHasNoPath)
{
    Schedule::Terms terms;
    terms.weight = 3.0;
    EXPECT_EQ(stepsOf(Schedule(terms), {End::Infeasible, End::Infeasible, End::Solved}),
              (Steps{{3.0, Change::None, false},
                     {3.0, Change::Refine, false},
                     {3.0, Change::Refine, false},
                     {1.0 + 2.0 / 3.0, Change::None, false}}));
}
}  // namespace
}  // namespace specplan::test
