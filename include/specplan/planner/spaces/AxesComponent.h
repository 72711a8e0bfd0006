// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "specplan/lattice/AxesFactor.h"
#include "specplan/lattice/Neighbourhood.h"
#include "specplan/planner/spaces/Component.h"

namespace specplan::planner
{
/// What a lattice has to know of one real axis of a state space.
struct RealAxis
{
    std::string name;
    double lower;
    double upper;
    bool wraps;      ///< lower and upper are the same place
    double origin;   ///< the lattice goes through here
    double spacing;  ///< greater than 0
    bool whole;      ///< takes whole numbers only: cannot be refined
};

/// Real axes with a Euclidean metric: RealVectorStateSpace, SO2, time, discrete values, and custom spaces through their
/// values. More than 2^30 units along an axis are refused with an ompl::Exception.
class AxesComponent : public Component
{
public:
    /// How to get at the values of a state of the component, one for each axis.
    struct Access
    {
        std::function<void(const ompl::base::State* state, double* values)> read;
        std::function<void(const double* values, ompl::base::State* state)> write;
    };

    AxesComponent(std::vector<RealAxis> axes, Access access, const LatticeOptions& options);

    [[nodiscard]] std::size_t dimension() const noexcept override
    {
        return axes_.size();
    }

    [[nodiscard]] unsigned axes() const noexcept override
    {
        return static_cast<unsigned>(axes_.size());
    }

    [[nodiscard]] std::unique_ptr<const lattice::Factor> factor(bool discreteMotions) const override;
    [[nodiscard]] bool canRefine() const noexcept override;
    void refine() override;
    void coarsen() override;
    [[nodiscard]] double coarseness() const override;
    void write(const lattice::Coordinate* node, ompl::base::State* state) const override;
    [[nodiscard]] std::vector<Coordinates> corners(const ompl::base::State* state, Joint joint) const override;
    [[nodiscard]] Target target(const ompl::base::State* state, bool exactly) const override;
    [[nodiscard]] double lowerBound(const lattice::Coordinate* node, const Target& target) const override;
    [[nodiscard]] double nodes() const override;
    void describe(std::ostream& out) const override;

    /// Whether no axis wraps around, so that a plain grid does.
    [[nodiscard]] bool isPlain() const noexcept;

    /// The plain grid. \param cornerCutting see GridSteps.
    [[nodiscard]] std::unique_ptr<const lattice::Neighbourhood> grid(bool discreteMotions, bool cornerCutting) const;

private:
    /// Length of a step by its offset in units.
    [[nodiscard]] double length(std::span<const lattice::Coordinate> offset) const noexcept;
    [[nodiscard]] bool needsCheck(std::span<const lattice::Coordinate> offset, bool discreteMotions) const noexcept;
    [[nodiscard]] std::vector<double> position(const ompl::base::State* state) const;
    [[nodiscard]] double alongGrid(std::span<const double> distance) const;

    std::vector<RealAxis> axes_;
    Access access_;
    LatticeOptions options_;
    std::vector<lattice::Axis> grid_;
    std::vector<double> units_;
};
}  // namespace specplan::planner
