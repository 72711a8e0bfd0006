// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <thread>
#include <vector>

#include "specplan/problems/fcl/RigidBodyChecker.h"

namespace specplan::test
{
/// A pose anywhere within the bounds. OMPL's own samplers start from the clock.
inline void samplePose(std::mt19937& random, const ompl::base::SpaceInformationPtr& si, ompl::base::State* state)
{
    auto& pose = *state->as<ompl::base::SE3StateSpace::StateType>();
    const auto& bounds = si->getStateSpace()->as<ompl::base::SE3StateSpace>()->getBounds();
    const auto along = [&](unsigned axis)
    { return std::uniform_real_distribution(bounds.low.at(axis), bounds.high.at(axis))(random); };
    pose.setX(along(0));
    pose.setY(along(1));
    pose.setZ(along(2));
    std::normal_distribution<double> any;
    auto& rotation = pose.rotation();
    rotation.x = any(random);
    rotation.y = any(random);
    rotation.z = any(random);
    rotation.w = any(random);
    si->enforceBounds(state);
}

/// Eight threads ask one checker of SE(3) the same questions in different orders and expect the answers that another
/// one gave to one thread. Distances come first. \param fewest that have to be valid, and that have to be invalid.
inline void expectOneThreadsAnswers(const ompl::base::SpaceInformationPtr& si, const problems::RigidBodyChecker& serial,
                                    const problems::RigidBodyChecker& shared, std::size_t count, int fewest)
{
    std::mt19937 random(1);
    std::vector<ompl::base::State*> states(count);
    std::vector<char> valid;
    std::vector<double> clearance;
    for (ompl::base::State*& state : states)
    {
        state = si->allocState();
        samplePose(random, si, state);
        valid.push_back(serial.isValid(state) ? 1 : 0);
        clearance.push_back(serial.clearance(state));
    }
    EXPECT_GE(std::ranges::count(valid, 1), fewest);
    EXPECT_GE(std::ranges::count(valid, 0), fewest);
    std::atomic<int> wrong = 0;
    {
        std::vector<std::thread> threads;
        for (std::size_t thread = 0; thread < 8; ++thread)
            threads.emplace_back(
                [&, thread]
                {
                    for (std::size_t i = 0; i < count; ++i)
                    {
                        const std::size_t at = (i + thread * count / 8) % count;
                        if (shared.clearance(states[at]) != clearance[at] ||
                            shared.isValid(states[at]) != (valid[at] != 0))
                            ++wrong;
                    }
                });
        for (std::thread& thread : threads)
            thread.join();
    }
    EXPECT_EQ(wrong, 0);
    for (ompl::base::State* state : states)
        si->freeState(state);
}
}  // namespace specplan::test
