// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "specplan/lattice/NodeTable.h"

namespace specplan::lattice
{
/// The steps out of one node, written by a Neighbourhood. Kept by the caller and used again: the buffers stay as large
/// as they ever were, and `count` says how much of them holds.
struct Steps
{
    struct Step
    {
        double cost;          ///< cost of the motion, greater than 0
        std::uint32_t index;  ///< number of the motion among those of a node, below Neighbourhood::maxSteps()
        bool motionCheck;     ///< whether the inside of the motion needs a check of its own
    };

    std::size_t count = 0;         ///< number of steps
    std::vector<Step> steps;       ///< the first `count` hold
    std::vector<Coordinate> ends;  ///< rows: where each step leads
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

    /// What a step is like wherever it starts.
    struct Pattern
    {
        double cost;
        bool motionCheck;
        std::vector<std::uint32_t> guards;  ///< steps whose ends have to be valid for this one, too; they exist where
                                            ///< it does
    };

    /// The steps by their index, if they are the same wherever they start. Empty if not; then no step has guards.
    [[nodiscard]] virtual std::span<const Pattern> patterns() const noexcept
    {
        return {};
    }

    /// Whether any step asks for a check of its motion.
    [[nodiscard]] virtual bool hasMotionChecks() const noexcept = 0;

    /// Writes all steps that start at `from` and stay inside the bounds, always in the same order.
    virtual void steps(const Coordinate* from, Steps& out) const = 0;

    /// Goes on from `to` the way `from` led to `to`; writes the result to `next`.
    /// \return false where this leaves the bounds or there is no such step.
    virtual bool goOn(const Coordinate* from, const Coordinate* to, Coordinate* next) const = 0;
};
}  // namespace specplan::lattice
