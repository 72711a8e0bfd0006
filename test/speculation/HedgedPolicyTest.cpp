// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/HedgedPolicy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "TextGrid.h"

namespace specplan::speculation
{
namespace
{
using lattice::CheckId;
using lattice::NodeId;
using test::TextGrid;

const std::vector<std::string> kEmptyRoom(9, "S.................G.");

/// All but certain, except for one column.
class DoubtsOneColumn : public OptimisticPredictor
{
public:
    explicit DoubtsOneColumn(const TextGrid& grid) : grid_(grid)
    {
    }

    [[nodiscard]] double probabilityValid(NodeId node) const override
    {
        return grid_.lattice.coordinates(node)[0] == 4 ? 0.6 : 0.99;
    }

private:
    const TextGrid& grid_;
};

/// How many of the first `count` proposals lie behind the doubtful column.
std::ptrdiff_t proposedBehind(Policy& policy, const TextGrid& grid, std::size_t count)
{
    std::vector<CheckId> proposed;
    policy.propose(count, proposed);
    EXPECT_EQ(proposed.size(), count);
    EXPECT_EQ(std::set<CheckId>(proposed.begin(), proposed.end()).size(), count) << "none twice";
    return std::ranges::count_if(proposed,
                                 [&](CheckId check) { return grid.lattice.coordinates(check.node())[0] > 4; });
}

TEST(HedgedPolicy, HalfOfWhatItProposesDoesNotRelyOnWhatIsDoubtful)
{
    TextGrid first(kEmptyRoom, 1);
    DoubtsOneColumn ofFirst(first);
    RunAheadPolicy one(first.lattice, first.broker, first.search, ofFirst, 1000.0);
    const std::ptrdiff_t alone = proposedBehind(one, first, 40);
    EXPECT_GT(alone, 20);

    TextGrid second(kEmptyRoom, 1);
    DoubtsOneColumn ofSecond(second);
    HedgedPolicy two(second.lattice, second.broker, second.search, ofSecond, 1000.0);
    const std::ptrdiff_t hedged = proposedBehind(two, second, 40);
    EXPECT_GT(hedged, 0);
    EXPECT_LT(hedged, alone);
}

TEST(HedgedPolicy, GoesOnWithOneShadowWhereTheOtherHasNothingLeft)
{
    TextGrid grid({"S....G"}, 1);
    OptimisticPredictor optimist;
    HedgedPolicy policy(grid.lattice, grid.broker, grid.search, optimist, 10.0);
    std::vector<CheckId> proposed;
    policy.propose(100, proposed);
    EXPECT_EQ(proposed.size(), 5U) << "all there are, once each";
}

TEST(HedgedPolicy, IsForGreedySearchesWithManyWorkers)
{
    for (const auto& [weight, workers, hedges] : {std::tuple{1.0, 128U, false}, {3.0, 8U, false}, {3.0, 9U, true}})
    {
        TextGrid grid(kEmptyRoom, 1);
        OptimisticPredictor optimist;
        const auto policy = makeRunAhead(grid.lattice, grid.broker, grid.search, optimist, weight, workers);
        EXPECT_EQ(dynamic_cast<HedgedPolicy*>(policy.get()) != nullptr, hedges) << weight << ' ' << workers;
    }
}
}  // namespace
}  // namespace specplan::speculation
