// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: part of the planner's public face.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <ompl/base/State.h>

namespace specplan
{
/// One axis of a lattice over a state space of the user's own class.
struct LatticeAxis
{
    std::string name;    ///< for messages and explain()
    double lower = 0.0;  ///< least value, in the axis's own unit; finite
    double upper = 0.0;  ///< greatest value; finite, and not less than `lower`
    bool wraps = false;  ///< whether `lower` and `upper` are the same place; the period is `upper - lower`
    bool whole = false;  ///< whether the axis takes whole numbers only

    /// Number of the axis's value among those of StateSpace::copyToReals(). Not needed where LatticeAxes has `read` and
    /// `write`.
    int value = -1;
};

/// Describes a state space to the planner, which otherwise finds out by moving each value of copyToReals() and looking
/// where enforceBounds() puts it. For classes whose values are not independent (quaternions), have no bounds, or come
/// round by something else than 2 pi.
///
/// Distances stay those of the space: steps cost what StateSpace::distance() says.
struct LatticeAxes
{
    /// Name of the space that is described; empty for the whole one, else it may be a part of a compound space.
    std::string space;

    /// At least one.
    std::vector<LatticeAxis> axes;

    /// Reads the values of a state, one for each axis. Empty, as `write` then has to be: the axes' values of
    /// copyToReals() are read and written; all other values are those of the first start.
    std::function<void(const ompl::base::State* state, double* values)> read;

    /// Writes a state from one value for each axis: all of the state, which comes from allocState(). Called by several
    /// workers at once, each with a state of its own.
    std::function<void(const double* values, ompl::base::State* state)> write;
};
}  // namespace specplan
