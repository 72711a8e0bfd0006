// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/StateSpace.h>

#include "specplan/planner/spaces/SpaceHooks.h"

namespace specplan::planner
{
/// A part of a state space that a component stands for, and how to find its states.
struct Part
{
    ompl::base::StateSpacePtr space;
    std::vector<unsigned> path;         ///< numbers of the subspaces that lead to it; empty for the whole space
    double weight;                      ///< of its distance in the distance of the whole space
    bool place = false;                 ///< where a body is in the plane or in space: all its axes have the same unit
    const LatticeAxes* axes = nullptr;  ///< what the user says of it; among the hooks

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
    /// Whether all of it is OMPL's own, so that a lattice state is whole once its values are written.
    bool isOmpls = true;
};

/// Takes a space apart into RealVector, SO2, SO3, time, discrete, Dubins, Reeds-Shepp, and what is left.
/// What the user has described stays whole.
/// \throws ompl::Exception for spaces over which there is no lattice (constrained ones), with the reason.
/// \param hooks have to outlive what is returned.
[[nodiscard]] Decomposition decompose(const ompl::base::StateSpacePtr& space, const SpaceHooks& hooks);

/// Whether a space is a Dubins or Reeds-Shepp space.
[[nodiscard]] bool isCar(const ompl::base::StateSpace& space);
}  // namespace specplan::planner
