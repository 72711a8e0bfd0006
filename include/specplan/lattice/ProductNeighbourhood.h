// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "specplan/lattice/Factor.h"
#include "specplan/lattice/Neighbourhood.h"

namespace specplan::lattice
{
/// Several factors side by side. A step is a step of one factor, or of several at once while they change no more than
/// `connectivity` axes together. The costs of the factors' steps add up; the motion is checked if any part of it is.
class ProductNeighbourhood : public Neighbourhood
{
public:
    /// \throws std::invalid_argument if there are no factors, or a node would have more than 65536 neighbours.
    ProductNeighbourhood(std::vector<std::unique_ptr<const Factor>> factors, unsigned connectivity);

    [[nodiscard]] std::size_t dimension() const noexcept override
    {
        return dimension_;
    }

    [[nodiscard]] std::uint32_t maxSteps() const noexcept override
    {
        return static_cast<std::uint32_t>(combinations_.size());
    }

    [[nodiscard]] bool hasMotionChecks() const noexcept override
    {
        return true;
    }

    [[nodiscard]] std::span<const Pattern> patterns() const noexcept override
    {
        return patterns_;
    }

    void steps(const Coordinate* from, Steps& out) const override;
    bool goOn(const Coordinate* from, const Coordinate* to, Coordinate* next) const override;

private:
    /// A step of one factor.
    struct Part
    {
        std::uint32_t factor;
        std::uint32_t step;
    };

    /// The parts of one step of the product: [first, last) of parts_.
    struct Combination
    {
        std::size_t first;
        std::size_t last;
    };

    void addCombinations(std::size_t factor, unsigned axesLeft, std::vector<Part>& parts);
    void addPatterns();
    bool take(const Coordinate* from, const Combination& combination, Coordinate* end, Factor::Taken& taken) const;

    std::vector<std::unique_ptr<const Factor>> factors_;
    std::vector<std::size_t> firstCoordinate_;  ///< factor -> its place among the coordinates
    std::size_t dimension_ = 0;
    std::vector<Combination> combinations_;  ///< by the step's index
    std::vector<Pattern> patterns_;          ///< the same, if all factors always cost the same
    std::vector<Part> parts_;
};
}  // namespace specplan::lattice
