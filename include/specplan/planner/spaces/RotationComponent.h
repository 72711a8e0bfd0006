// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "specplan/lattice/RotationFactor.h"
#include "specplan/planner/spaces/Component.h"

namespace specplan::planner
{
/// SO3: a grid of rotations, turned so that one of them is the start's.
class RotationComponent : public Component
{
public:
    /// \param cells steps from one rotation to another a quarter turn away on the first lattice, at least 1.
    /// \param origin state of the SO3StateSpace.
    RotationComponent(std::string name, lattice::Coordinate cells, const ompl::base::State* origin,
                      const LatticeOptions& options);

    [[nodiscard]] std::size_t dimension() const noexcept override
    {
        return 4;
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
    /// The rotation of a state as seen from the origin.
    [[nodiscard]] lattice::Quaternion relative(const ompl::base::State* state) const;

    std::string name_;
    LatticeOptions options_;
    lattice::Quaternion origin_;
    lattice::RotationGrid grid_;
    lattice::Coordinate stride_;
};
}  // namespace specplan::planner
