// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <ompl/base/StateSpace.h>

namespace specplan::test
{
/// A state space with obstacles, a start and goals: one problem of the contract test.
struct SpaceCase
{
    std::string name;
    std::function<ompl::base::StateSpacePtr()> make;
    std::vector<double> start;                                          ///< by StateSpace::copyFromReals
    std::vector<std::vector<double>> goals;                             ///< the first one is the nearer one
    std::function<double(const std::vector<double>& reals)> clearance;  ///< valid where above 0
    double resolution = 0.1;
    double validity = 0.01;  ///< longest valid segment as a fraction of the extent
};

/// One of every kind of space that OMPL ships, and some of a user's own.
[[nodiscard]] const std::vector<SpaceCase>& spaceCases();
}  // namespace specplan::test
