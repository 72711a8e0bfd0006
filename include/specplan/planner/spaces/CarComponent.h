// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <ompl/base/ScopedState.h>
#include <ompl/base/StateSpace.h>

#include "specplan/lattice/PrimitiveFactor.h"
#include "specplan/planner/spaces/Component.h"

namespace specplan::planner
{
/// Dubins and Reeds-Shepp cars: a state lattice of places and 16 headings, turned so that it goes through the start,
/// whose motions are the space's own shortest curves.
///
/// For each heading the curves to all nodes nearby are sorted by length, and one is kept if it makes no loop and no two
/// kept ones make the same way at nearly the same length. Where the space drives forward only, so do all curves.
///
/// Reference: M. Pivtoraiko, R. Knepper, A. Kelly, "Differentially constrained mobile robot motion planning in state
/// lattices", 2009.
class CarComponent : public Component
{
public:
    static constexpr lattice::Coordinate kHeadings = 16;

    /// \param space a Dubins or Reeds-Shepp space. \param spacing of places on the first lattice.
    CarComponent(ompl::base::StateSpacePtr space, std::string name, double spacing, const ompl::base::State* origin,
                 const LatticeOptions& options);

    [[nodiscard]] std::size_t dimension() const noexcept override
    {
        return 3;
    }

    [[nodiscard]] unsigned axes() const noexcept override
    {
        return 3;
    }

    [[nodiscard]] std::unique_ptr<const lattice::Factor> factor(bool discreteMotions) const override;

    [[nodiscard]] bool canRefine() const noexcept override
    {
        return stride_ > 1;
    }

    void refine() override;
    [[nodiscard]] double coarseness() const override;
    void write(const lattice::Coordinate* node, ompl::base::State* state) const override;
    [[nodiscard]] std::vector<Coordinates> corners(const ompl::base::State* state, Joint joint) const override;
    [[nodiscard]] Target target(const ompl::base::State* state, bool exactly) const override;
    [[nodiscard]] double lowerBound(const lattice::Coordinate* node, const Target& target) const override;
    [[nodiscard]] double nodes() const override;
    void describe(std::ostream& out) const override;

private:
    using Primitives = std::vector<std::vector<lattice::PrimitiveFactor::Primitive>>;

    [[nodiscard]] Primitives makePrimitives() const;
    [[nodiscard]] lattice::Coordinate reach() const;

    ompl::base::StateSpacePtr space_;
    ompl::base::StateSpacePtr shortest_;  ///< whose curves are no longer than any way along those of the space
    std::string name_;
    LatticeOptions options_;
    lattice::PrimitiveFactor::Frame frame_;
    double heading_;
    double unit_;
    double turn_;  ///< length of the arc from one heading to the next
    lattice::Coordinate stride_;
    Primitives primitives_;
    mutable ompl::base::ScopedState<> here_;   ///< scratch of lowerBound(), search thread
    mutable ompl::base::ScopedState<> there_;  ///< scratch of lowerBound(), search thread
};
}  // namespace specplan::planner
