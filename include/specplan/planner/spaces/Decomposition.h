// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/StateSpace.h>

namespace specplan::planner
{
/// A part of a state space that a component stands for, and how to find its states.
struct Part
{
    ompl::base::StateSpacePtr space;
    std::vector<unsigned> path;  ///< numbers of the subspaces that lead to it; empty for the whole space
    double weight;               ///< of its distance in the distance of the whole space
    bool place = false;          ///< where a body is in the plane or in space: all its axes have the same unit

    [[nodiscard]] ompl::base::State* of(ompl::base::State* whole) const;
    [[nodiscard]] const ompl::base::State* of(const ompl::base::State* whole) const;
};

/// A state space taken apart.
struct Decomposition
{
    std::vector<Part> parts;
    /// Whether the distance of the space is the weighted sum of those of its parts, each as OMPL defines it. A class of
    /// the user's own may measure differently.
    bool sumsDistances = true;
};

/// Takes a space apart into RealVector, SO2, SO3, time, discrete, Dubins, Reeds-Shepp, and what is left.
/// \throws ompl::Exception for spaces over which there is no lattice (constrained ones), with the reason.
[[nodiscard]] Decomposition decompose(const ompl::base::StateSpacePtr& space);

/// Whether a space is a Dubins or Reeds-Shepp space.
[[nodiscard]] bool isCar(const ompl::base::StateSpace& space);
}  // namespace specplan::planner
