// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace specplan::lattice
{
/// How the costs of motions make the cost of a path, where they do not simply add up (the worst clearance on the way,
/// the largest state cost, ...). Costs are numbers of which the smaller is the better one; whoever maximises negates.
///
/// A search is right for every algebra in which a path never gets better by going on, and the better of two ways to a
/// node stays the better one whatever follows.
class CostAlgebra
{
public:
    virtual ~CostAlgebra() = default;

    /// Cost of a path that has cost `path` and goes on by something of cost `more`.
    [[nodiscard]] virtual double combine(double path, double more) const = 0;

    /// Cost of a path that goes nowhere: combine(identity(), c) is c.
    [[nodiscard]] virtual double identity() const = 0;
};

/// Puts costs together by an algebra, or adds them up if there is none.
class CostSum
{
public:
    CostSum() = default;

    /// \param algebra must outlive the sum; nullptr adds up.
    explicit CostSum(const CostAlgebra* algebra) noexcept : algebra_(algebra)
    {
    }

    [[nodiscard]] double operator()(double path, double more) const
    {
        return algebra_ == nullptr ? path + more : algebra_->combine(path, more);
    }

    [[nodiscard]] double identity() const
    {
        return algebra_ == nullptr ? 0.0 : algebra_->identity();
    }

    /// Whether costs add up as numbers; only then has a weight of the heuristic a meaning.
    [[nodiscard]] bool adds() const noexcept
    {
        return algebra_ == nullptr;
    }

private:
    const CostAlgebra* algebra_ = nullptr;
};
}  // namespace specplan::lattice
