// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <unordered_map>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include "specplan/lattice/CostAlgebra.h"
#include "specplan/lattice/MotionCosts.h"
#include "specplan/planner/Embedding.h"
#include "specplan/util/SegmentedRows.h"

namespace specplan::planner
{
/// Whether the objective is exactly path length, which the lattice knows itself.
[[nodiscard]] bool isPathLength(const ompl::base::OptimizationObjective& objective);

/// Whether the objective is one of OMPL's own that never ask the state validity checker.
[[nodiscard]] bool asksNoChecker(const ompl::base::OptimizationObjective& objective);

/// Costs by an objective of OMPL: of motions, evaluated in the checks, and of paths, by the objective's own algebra.
///
/// The search wants numbers of which the smaller is the better one; an objective that prefers larger ones is negated.
/// A path that would get better by going on keeps the cost that it had: no search could end otherwise.
///
/// Threads: `evaluate` by workers, each motion once; all else by the search thread, `known` once the check is back.
class ObjectiveCosts : public lattice::MotionCosts, public lattice::CostAlgebra
{
public:
    /// \throws ompl::Exception if the objective prefers neither smaller nor larger costs.
    ObjectiveCosts(const ompl::base::SpaceInformation& si, const ompl::base::OptimizationObjective& objective,
                   const lattice::Lattice& lattice, const Embedding& embedding);

    /// Cost of a motion, with the cost of ending at `end`; search thread.
    [[nodiscard]] double ofMotion(const ompl::base::State* from, lattice::NodeId end,
                                  const ompl::base::State* to) const;

    /// Computes the cost of a motion and keeps it.
    void evaluate(lattice::MotionId motion, const ompl::base::State* from, const ompl::base::State* to);

    /// What `evaluate` found, and a way to say it instead.
    [[nodiscard]] double evaluated(lattice::MotionId motion) const noexcept
    {
        return costs_[motion];
    }
    void set(lattice::MotionId motion, double cost) noexcept
    {
        costs_[motion] = cost;
    }

    /// Ends of paths have this cost besides; for terminals.
    void setTerminalCost(lattice::NodeId node, double cost);

    /// Whether costs add up as numbers.
    [[nodiscard]] bool adds() const noexcept
    {
        return adds_;
    }

    /// Whether workers may call the objective at once although each has a checker of its own.
    [[nodiscard]] bool asksNoChecker() const
    {
        return planner::asksNoChecker(objective_);
    }

    void makeRoom(std::size_t motions) override;
    [[nodiscard]] double lowerBound(lattice::NodeId from, lattice::NodeId to) const override;
    [[nodiscard]] double known(lattice::MotionId motion) const override;
    [[nodiscard]] double combine(double path, double more) const override;
    [[nodiscard]] double identity() const override;

    /// The search's number for a cost, and back.
    [[nodiscard]] double number(ompl::base::Cost cost) const noexcept
    {
        return sign_ * cost.value();
    }
    [[nodiscard]] ompl::base::Cost cost(double number) const noexcept
    {
        return ompl::base::Cost(sign_ * number);
    }

    /// The number of a lower bound that an objective gives; one that tells nothing if it is not a number.
    [[nodiscard]] double bound(ompl::base::Cost cost) const;

private:
    [[nodiscard]] double ofMotion(const ompl::base::State* from, const ompl::base::State* to) const;
    [[nodiscard]] double withEnd(double cost, lattice::NodeId end) const;

    const ompl::base::OptimizationObjective& objective_;
    const lattice::Lattice& lattice_;
    const Embedding& embedding_;
    double sign_ = 1.0;
    bool adds_ = false;
    util::SegmentedRows<double> costs_;
    std::unordered_map<lattice::NodeId, double> terminalCosts_;
    StateHandle from_;  ///< scratch of the search thread
    StateHandle to_;    ///< scratch of the search thread
};
}  // namespace specplan::planner
