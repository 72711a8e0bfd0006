// SPDX-License-Identifier: BSD-3-Clause
// The lower bounds of every lattice: consistent along every motion, and never above the way that is left.
#include <gtest/gtest.h>

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include "SpaceCases.h"
#include "specplan/lattice/Lattice.h"
#include "specplan/planner/Embedding.h"

namespace specplan::test
{
namespace
{
namespace ob = ompl::base;
using lattice::NodeId;

class LowerBounds : public testing::TestWithParam<std::size_t>
{
};

TEST_P(LowerBounds, AreConsistentOnTheirLattice)
{
    const SpaceCase& problem = spaceCases()[GetParam()];
    auto si = std::make_shared<ob::SpaceInformation>(problem.make());
    si->setStateValidityChecker([](const ob::State*) { return true; });
    si->setup();
    ob::ScopedState<> start(si->getStateSpace());
    ob::ScopedState<> goal(si->getStateSpace());
    start.random();  // values that copyFromReals does not reach
    si->copyState(goal.get(), start.get());
    si->getStateSpace()->copyFromReals(start.get(), problem.start);
    si->getStateSpace()->copyFromReals(goal.get(), problem.goals[0]);
    PlannerSettings settings;
    settings.resolution = problem.resolution;
    const planner::Embedding embedding(*si, settings, {}, start.get());
    if (!embedding.sumsDistances())
        GTEST_SKIP() << "steps cost what the space says, and so do lower bounds";
    lattice::Lattice lattice(embedding.neighbourhood(true));

    for (const bool exactly : {true, false})
    {
        const planner::Embedding::Target target = embedding.target(goal.get(), exactly);
        const auto bound = [&](NodeId node) { return embedding.lowerBound(lattice.coordinates(node).data(), target); };
        lattice::Successors successors;
        lattice.node(embedding.corners(start.get(), planner::Component::Joint::Leaving).front().data());
        for (NodeId node = 0; node < lattice.size() && node < 600; ++node)
        {
            lattice.successors(node, successors);
            const double here = bound(node);
            for (const lattice::Successors::Edge& edge : successors.edges)
                EXPECT_LE(here, edge.cost + bound(edge.node) + 1e-9);
        }
        const planner::StateHandle state(*si);
        for (const auto& corner : embedding.corners(goal.get(), planner::Component::Joint::Entering))
        {
            const NodeId node = lattice.node(corner.data());
            embedding.write(lattice, node, state.get());
            EXPECT_LE(bound(node), si->distance(state.get(), goal.get()) + 1e-9);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, LowerBounds, testing::Range(std::size_t{0}, spaceCases().size()),
                         [](const testing::TestParamInfo<std::size_t>& of) { return spaceCases()[of.param].name; });
}  // namespace
}  // namespace specplan::test
