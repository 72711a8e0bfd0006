// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <ostream>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "specplan/lattice/Lattice.h"
#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/StateHandle.h"
#include "specplan/planner/spaces/Components.h"

namespace specplan::planner
{
/// Puts a lattice over a state space: which state stands for which node. The space is taken apart into components, each
/// of which has a lattice of its own.
///
/// Threads: built by one; `write` may then be called by any. Terminals are added by the search thread before their
/// nodes are handed to workers.
class Embedding
{
public:
    using Coordinates = Component::Coordinates;
    using Joint = Component::Joint;

    /// A goal, for lower bounds; a part for each component.
    using Target = std::vector<Component::Target>;

    /// \param origin the lattice goes exactly through this state.
    /// \throws ompl::Exception if there is no lattice over the space, or the settings do not fit it.
    /// \param coarsens whether the lattice may be searched with twice the usual spacing first.
    Embedding(const ompl::base::SpaceInformation& si, const PlannerSettings& settings, const SpaceHooks& hooks,
              const ompl::base::State* origin, bool coarsens = false);

    /// The steps of the lattice as it is now. \param discreteMotions whether motions as short as one valid segment need
    /// no check of their inside.
    [[nodiscard]] std::unique_ptr<const lattice::Neighbourhood> neighbourhood(bool discreteMotions) const;

    /// Whether distances are the sum of those of the components, so that steps and lower bounds are known.
    [[nodiscard]] bool sumsDistances() const noexcept
    {
        return decomposition_.sumsDistances;
    }

    /// Whether states are whole once their values are written: all classes are OMPL's, and nobody else writes.
    [[nodiscard]] bool writesWholeStates() const noexcept
    {
        return decomposition_.isOmpls && !hooks_.complete;
    }

    /// What the space is made up of; each has a lattice of its own.
    [[nodiscard]] const std::vector<Part>& parts() const noexcept
    {
        return decomposition_.parts;
    }

    /// Number of degrees of freedom.
    [[nodiscard]] unsigned axes() const noexcept
    {
        return components_.axes;
    }

    /// Halves the spacing. All nodes stay what they are. \return false if it cannot become any finer.
    bool refine();

    /// Whether `coarsen` is possible: the spacing is the usual one, and may be doubled.
    [[nodiscard]] bool canCoarsen() const noexcept
    {
        return spacing_ == Spacing::Usual;
    }

    /// Doubles the spacing, but of rotations and cars, and of angles beside many other axes; `refine` undoes that.
    void coarsen();

    /// Whether `coarsen` has been called, and `refine` not since.
    [[nodiscard]] bool isCoarse() const noexcept
    {
        return spacing_ == Spacing::Coarse;
    }

    /// Number of the spacing: greater for finer ones, 0 for the usual one.
    [[nodiscard]] int level() const noexcept
    {
        return level_;
    }

    /// Greatest step along one axis as a multiple of the longest motion that needs no check.
    [[nodiscard]] double coarseness() const;

    /// Nodes that a motion may join the state to, the nearest one first; none if the state lies too far out.
    [[nodiscard]] std::vector<Coordinates> corners(const ompl::base::State* state, Joint joint) const;

    /// \param exactly whether the goal is this very state; otherwise states nearby may do as well.
    [[nodiscard]] Target target(const ompl::base::State* state, bool exactly) const;

    /// A length that every way on the lattice to the target has at least; consistent where `sumsDistances`.
    [[nodiscard]] double lowerBound(const lattice::Coordinate* node, const Target& target) const;

    /// Registers the state of the next terminal that the lattice makes.
    void addTerminal(const ompl::base::State* state);

    /// Writes the state of a node.
    void write(const lattice::Lattice& lattice, lattice::NodeId node, ompl::base::State* state) const;

    /// Segments that a motion is divided into for validation, at least 1: never fewer than OMPL's own count, nor than
    /// the length of a car's curve asks for (OMPL before 1.7 takes the straight distance there).
    [[nodiscard]] unsigned segments(const ompl::base::State* from, const ompl::base::State* to) const;

    /// Whether states between two states inside the bounds may lie outside of them.
    [[nodiscard]] bool curves() const noexcept
    {
        return curves_;
    }

    /// Number of nodes, roughly.
    [[nodiscard]] double nodes() const;

    void describe(std::ostream& out) const;

private:
    enum class Spacing
    {
        Coarse,
        Usual,
        Fixed  ///< as it was asked for, or refined, or never to be coarse
    };

    const ompl::base::SpaceInformation& si_;
    PlannerSettings settings_;
    SpaceHooks hooks_;
    Decomposition decomposition_;
    Components components_;
    bool curves_ = false;
    int level_ = 0;
    Spacing spacing_ = Spacing::Fixed;
    std::vector<std::size_t> firstCoordinate_;
    std::vector<StateHandle> terminals_;
};
}  // namespace specplan::planner
