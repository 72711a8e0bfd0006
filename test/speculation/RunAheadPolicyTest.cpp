// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/RunAheadPolicy.h"

#include <gtest/gtest.h>

#include <random>

#include "TextGrid.h"
#include "specplan/speculation/LearningPredictor.h"

namespace specplan::speculation
{
namespace
{
using lattice::CheckId;
using lattice::NodeId;
using search::SearchStatus;
using test::TextGrid;

/// Knows every verdict beforehand.
class Oracle : public OptimisticPredictor
{
public:
    explicit Oracle(const TextGrid& grid) : grid_(grid)
    {
    }

    [[nodiscard]] double probabilityValid(NodeId node) const override
    {
        return grid_.isFree(node) ? 1.0 : 1e-9;
    }

private:
    const TextGrid& grid_;
};

const std::vector<std::string> kWall{"....................", "....................", "...........#........",
                                     "...........#........", ".S.........#......G.", "...........#........",
                                     "...........#........", "....................", "...................."};

struct Result
{
    double seconds;
    validity::CheckStatistics counts;
    std::uint64_t order;
};

Result runWith(bool oracle, unsigned workers, bool motionChecks = false)
{
    TextGrid grid(kWall, workers, motionChecks);
    OptimisticPredictor optimist;
    Oracle seer(grid);
    RunAheadPolicy policy(grid.lattice, grid.broker, grid.search, oracle ? static_cast<Predictor&>(seer) : optimist,
                          1.0);
    grid.use(policy);
    EXPECT_EQ(grid.run(), SearchStatus::Solved);
    return {grid.broker.now(), grid.broker.statistics(), grid.search.orderHash()};
}

Result runSequentially(bool motionChecks = false)
{
    TextGrid grid(kWall, 1, motionChecks);
    EXPECT_EQ(grid.run(), SearchStatus::Solved);
    return {grid.broker.now(), grid.broker.statistics(), grid.search.orderHash()};
}

TEST(RunAheadPolicy, WithRightPredictionsNothingIsWasted)
{
    const Result sequential = runSequentially();
    for (const unsigned workers : {2U, 4U, 8U})
    {
        const Result result = runWith(true, workers);
        EXPECT_EQ(result.order, sequential.order);
        EXPECT_EQ(result.counts.checksUsed, sequential.counts.checksUsed);
        EXPECT_EQ(result.counts.accuracy(), 1.0) << workers << " workers";
        EXPECT_GT(sequential.seconds / result.seconds, 0.9 * workers);
    }
}

TEST(RunAheadPolicy, FollowsTheSearchWhereAnOptimistIsWrong)
{
    const Result sequential = runSequentially();
    for (const unsigned workers : {2U, 8U, 64U})
    {
        const Result result = runWith(false, workers);
        EXPECT_EQ(result.order, sequential.order);
        EXPECT_GT(result.counts.accuracy(), 0.5);
        EXPECT_LT(result.seconds, sequential.seconds);
    }
    EXPECT_GT(sequential.seconds / runWith(false, 4).seconds, 3.5);
}

TEST(RunAheadPolicy, ChecksTheInsideOfMotionsAhead)
{
    const Result sequential = runSequentially(true);
    const Result result = runWith(false, 4, true);
    EXPECT_EQ(result.order, sequential.order);
    EXPECT_EQ(result.counts.checksUsed, sequential.counts.checksUsed);
    EXPECT_GT(sequential.seconds / result.seconds, 3.0);
}

TEST(RunAheadPolicy, ProposesInTheOrderInWhichTheSearchNeedsThem)
{
    // In an open plane all predictions hold: what is proposed is what the search asks for, in its order.
    TextGrid first(std::vector<std::string>(9, "S.................G."), 1);
    EXPECT_EQ(first.run(), SearchStatus::Solved);
    TextGrid second(std::vector<std::string>(9, "S.................G."), 1);
    OptimisticPredictor optimist;
    RunAheadPolicy policy(second.lattice, second.broker, second.search, optimist, 1.0);
    std::vector<CheckId> proposed;
    policy.propose(first.checked.size(), proposed);
    const auto at = [](const TextGrid& grid, CheckId check)
    {
        return std::vector<lattice::Coordinate>(grid.lattice.coordinates(check.node()).begin(),
                                                grid.lattice.coordinates(check.node()).end());
    };
    ASSERT_GE(proposed.size() + 8, first.checked.size()) << "all but those around the goal";
    for (std::size_t i = 0; i < proposed.size(); ++i)
        ASSERT_EQ(at(second, proposed[i]), at(first, first.checked[i])) << i;
}

/// A lattice has many equally good ways, and the search asks for the motion of the one that it finds first.
TEST(RunAheadPolicy, ForeseesWhichOfEquallyGoodWaysTheSearchTakes)
{
    double sequential = 0.0;
    double parallel = 0.0;
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        std::vector<std::string> rows(40, std::string(60, '.'));
        std::mt19937 random(seed);
        for (std::string& row : rows)
            for (char& cell : row)
                cell = random() % 4 == 0 ? '#' : '.';
        rows[5][3] = 'S';
        rows[33][55] = 'G';
        const auto secondsWith = [&rows](unsigned workers)
        {
            TextGrid grid(rows, workers, true);
            LearningPredictor learning(grid.lattice);
            RunAheadPolicy policy(grid.lattice, grid.broker, grid.search, learning, 1.0);
            if (workers > 1)
                grid.use(policy);
            static_cast<void>(grid.run());
            return grid.broker.now();
        };
        sequential += secondsWith(1);
        parallel += secondsWith(32);
    }
    EXPECT_GT(sequential / parallel, 14.7);
}
}  // namespace
}  // namespace specplan::speculation
