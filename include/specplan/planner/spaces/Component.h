// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <ostream>
#include <vector>

#include <ompl/base/State.h>

#include "specplan/lattice/Factor.h"

namespace specplan::planner
{
class CarTable;

/// What all components are told of the lattice.
struct LatticeOptions
{
    double weight;          ///< cost of a motion of length 1
    double longest;         ///< length of a motion whose inside needs no check; negative if every inside needs one
    unsigned levels;        ///< how often the lattice can be refined
    unsigned connectivity;  ///< how many axes may change in one step, at least 1
};

/// One part of a state space that cannot be taken apart any further, and the lattice over it.
///
/// Coordinates count in units of the finest lattice there will be; `refine` halves the step, and every node stays what
/// it was. The lattice goes exactly through the state that the component was made with.
///
/// Threads: built and refined by one; `write` may be called by any.
class Component
{
public:
    using Coordinates = std::vector<lattice::Coordinate>;

    /// Where a goal lies, for lower bounds.
    struct Target
    {
        std::vector<double> values;
        std::shared_ptr<CarTable> table;  ///< of a car, if the goal is this very state
        double saving = 0.0;  ///< by how much a motion into the goal may be shorter than the lattice's own way
    };

    /// Which way a state off the lattice is joined to it.
    enum class Joint
    {
        Leaving,  ///< motions go from the state to nodes
        Entering  ///< motions go from nodes to the state
    };

    virtual ~Component() = default;

    /// Number of lattice coordinates.
    [[nodiscard]] virtual std::size_t dimension() const noexcept = 0;

    /// Number of degrees of freedom.
    [[nodiscard]] virtual unsigned axes() const noexcept = 0;

    /// The steps of the lattice as it is now. \param discreteMotions whether the inside of short motions need not be
    /// checked.
    [[nodiscard]] virtual std::unique_ptr<const lattice::Factor> factor(bool discreteMotions) const = 0;

    /// Whether `refine` has something left to do.
    [[nodiscard]] virtual bool canRefine() const noexcept = 0;

    /// Halves the steps; does nothing where there is nothing left.
    virtual void refine() = 0;

    /// Doubles the steps, which `refine` undoes; does nothing where that is not possible.
    virtual void coarsen()
    {
    }

    /// Length of the shortest step of one axis, as a multiple of the longest motion that needs no check of its inside.
    [[nodiscard]] virtual double coarseness() const = 0;

    /// Writes the state of a node.
    virtual void write(const lattice::Coordinate* node, ompl::base::State* state) const = 0;

    /// Nodes that a motion may join the state to, the nearest one first; none if the state lies too far out.
    [[nodiscard]] virtual std::vector<Coordinates> corners(const ompl::base::State* state, Joint joint) const = 0;

    /// \param exactly whether the goal is this very state; otherwise states nearby may do as well.
    [[nodiscard]] virtual Target target(const ompl::base::State* state, bool exactly) const = 0;

    /// A cost that every way on the lattice from the node to the target has at least; consistent.
    [[nodiscard]] virtual double lowerBound(const lattice::Coordinate* node, const Target& target) const = 0;

    /// Number of nodes, roughly.
    [[nodiscard]] virtual double nodes() const = 0;

    /// One line for each axis.
    virtual void describe(std::ostream& out) const = 0;
};
}  // namespace specplan::planner
