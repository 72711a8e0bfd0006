// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "specplan/lattice/NodeTable.h"

namespace specplan::lattice
{
/// The steps out of one node, written by a Neighbourhood. Kept by the caller and used again, so nothing is allocated
/// once the buffers have grown.
struct Steps
{
    struct Step
    {
        double cost;                ///< cost of the motion, greater than 0
        std::uint32_t index;        ///< number of the motion among those of a node, below Neighbourhood::maxSteps()
        std::uint32_t firstGuard;   ///< guards of this step: rows [firstGuard, firstGuard + guards) of `guards`
        std::uint16_t guards;       ///< number of guards
        bool motionCheck;           ///< whether the inside of the motion needs a check of its own
    };

    std::vector<Step> steps;
    std::vector<Coordinate> ends;    ///< steps.size() rows: where each step leads
    std::vector<Coordinate> guards;  ///< rows: further nodes whose states have to be valid for a step to be taken

    void clear() noexcept
    {
        steps.clear();
        ends.clear();
        guards.clear();
    }
};

/// Which nodes can be reached from a node in one motion. Depends on coordinates only, never on verdicts.
///
/// Threads: const and without hidden state; any thread.
class Neighbourhood
{
public:
    virtual ~Neighbourhood() = default;

    [[nodiscard]] virtual std::size_t dimension() const noexcept = 0;

    /// One more than the greatest Step::index.
    [[nodiscard]] virtual std::uint32_t maxSteps() const noexcept = 0;

    /// Whether any step asks for a check of its motion.
    [[nodiscard]] virtual bool hasMotionChecks() const noexcept = 0;

    /// Writes all steps that start at `from` and stay inside the bounds, always in the same order.
    virtual void steps(const Coordinate* from, Steps& out) const = 0;

    /// Goes on from `to` the way `from` led to `to`; writes the result to `next`.
    /// \return false where this leaves the bounds or there is no such step.
    virtual bool goOn(const Coordinate* from, const Coordinate* to, Coordinate* next) const = 0;
};
}  // namespace specplan::lattice
