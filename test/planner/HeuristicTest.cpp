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

ob::SpaceInformationPtr spaceOf(const SpaceCase& problem)
{
    auto si = std::make_shared<ob::SpaceInformation>(problem.make());
    si->setStateValidityChecker([](const ob::State*) { return true; });
    si->setup();
    return si;
}

planner::Embedding embeddingOf(const SpaceCase& problem, const ob::SpaceInformation& si, const ob::State* start)
{
    PlannerSettings settings;
    settings.resolution = problem.resolution;
    return planner::Embedding(si, settings, {}, start);
}

/// Cases whose lower bounds are the lattice's own. Where steps cost what the space says, so do lower bounds.
std::vector<std::size_t> casesThatSumDistances()
{
    std::vector<std::size_t> cases;
    for (std::size_t i = 0; i < spaceCases().size(); ++i)
    {
        const SpaceCase& problem = spaceCases()[i];
        const ob::SpaceInformationPtr si = spaceOf(problem);
        ob::ScopedState<> start(si->getStateSpace());
        start.random();
        si->getStateSpace()->copyFromReals(start.get(), problem.start);
        if (embeddingOf(problem, *si, start.get()).sumsDistances())
            cases.push_back(i);
    }
    return cases;
}

class LowerBounds : public testing::TestWithParam<std::size_t>
{
};

TEST_P(LowerBounds, AreConsistentOnTheirLattice)
{
    const SpaceCase& problem = spaceCases()[GetParam()];
    const ob::SpaceInformationPtr si = spaceOf(problem);
    ob::ScopedState<> start(si->getStateSpace());
    ob::ScopedState<> goal(si->getStateSpace());
    start.random();  // values that copyFromReals does not reach
    si->copyState(goal.get(), start.get());
    si->getStateSpace()->copyFromReals(start.get(), problem.start);
    si->getStateSpace()->copyFromReals(goal.get(), problem.goals[0]);
    const planner::Embedding embedding = embeddingOf(problem, *si, start.get());
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

INSTANTIATE_TEST_SUITE_P(All, LowerBounds, testing::ValuesIn(casesThatSumDistances()),
                         [](const testing::TestParamInfo<std::size_t>& of) { return spaceCases()[of.param].name; });
}  // namespace
}  // namespace specplan::test
