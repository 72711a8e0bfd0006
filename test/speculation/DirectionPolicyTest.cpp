// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/DirectionPolicy.h"

#include <gtest/gtest.h>

#include "TextGrid.h"

namespace specplan::speculation
{
namespace
{
using lattice::CheckId;
using test::TextGrid;

const std::vector<std::string> kOpen(9, "S.......G.");

std::vector<CheckId> proposals(DirectionPolicy& policy, std::size_t count)
{
    std::vector<CheckId> out;
    policy.propose(count, out);
    return out;
}

TEST(DirectionPolicy, ProposesTheNeighboursOfEachStepAlongTheDirectionNearestFirst)
{
    TextGrid grid(kOpen, 1);
    DirectionPolicy policy(grid.lattice, grid.broker, 2);
    policy.expanding(grid.node(3, 4), grid.node(2, 4));
    const auto all = proposals(policy, 100);
    // Around (4, 4): eight. Around (5, 4): eight, of which (4, 4) and the three beyond are new.
    ASSERT_EQ(all.size(), 12U);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const auto at = grid.lattice.coordinates(all[i].node());
        EXPECT_LE(std::abs(at[0] - (i < 8 ? 4 : 5)), 1);
        EXPECT_LE(std::abs(at[1] - 4), 1);
    }
}

TEST(DirectionPolicy, ProposesNoMoreThanAskedForAndNothingKnown)
{
    TextGrid grid(kOpen, 1);
    DirectionPolicy policy(grid.lattice, grid.broker, 4);
    policy.expanding(grid.node(3, 4), grid.node(2, 4));
    EXPECT_EQ(proposals(policy, 5).size(), 5U);
    const CheckId known = CheckId::ofState(grid.node(5, 4));
    grid.broker.setVerdict(known, true);
    for (const CheckId check : proposals(policy, 100))
        EXPECT_NE(check, known);
}

TEST(DirectionPolicy, StopsAtTheEdgeAndHasNothingToSayOfAStart)
{
    TextGrid grid(kOpen, 1);
    DirectionPolicy policy(grid.lattice, grid.broker, 4);
    EXPECT_TRUE(proposals(policy, 10).empty()) << "before the first expansion";
    policy.expanding(grid.node(0, 0), lattice::kNoNode);
    EXPECT_TRUE(proposals(policy, 10).empty());
    policy.expanding(grid.node(9, 4), grid.node(8, 4));
    EXPECT_TRUE(proposals(policy, 10).empty());
}

TEST(DirectionPolicy, ProposesAMotionOnceBothItsEndsAreValid)
{
    TextGrid grid(kOpen, 1, true);
    DirectionPolicy policy(grid.lattice, grid.broker, 1);
    policy.expanding(grid.node(3, 4), grid.node(2, 4));
    for (const CheckId check : proposals(policy, 100))
        EXPECT_FALSE(check.isMotion());
    grid.broker.setVerdict(CheckId::ofState(grid.node(4, 4)), true);
    grid.broker.setVerdict(CheckId::ofState(grid.node(5, 4)), true);
    std::size_t motions = 0;
    for (const CheckId check : proposals(policy, 100))
        motions += check.isMotion() ? 1 : 0;
    EXPECT_EQ(motions, 1U);
}
}  // namespace
}  // namespace specplan::speculation
