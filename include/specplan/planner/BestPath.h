// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

namespace specplan::planner
{
/// The best path that a query has found so far, and how OMPL gets to know of it.
class BestPath
{
public:
    using Path = std::shared_ptr<ompl::geometric::PathGeometric>;

    [[nodiscard]] explicit operator bool() const noexcept
    {
        return cost_.has_value();
    }

    /// There must be one.
    [[nodiscard]] ompl::base::Cost cost() const noexcept
    {
        return *cost_;
    }

    void reset();

    /// Whether the path still leads to the goal, if it did when it was found: a goal may have been changed since.
    [[nodiscard]] bool leadsTo(const ompl::base::Goal& goal) const;

    /// Takes a path as the best one, and tells whoever wants to know at once.
    void take(Path path, ompl::base::Cost cost, const ompl::base::Planner& planner);

    /// Gives OMPL the path, unless it has it.
    void publish(const ompl::base::Planner& planner) const;

private:
    std::optional<ompl::base::Cost> cost_;
    Path path_;
    bool satisfied_ = false;  ///< the goal was satisfied by the end of the path
};
}  // namespace specplan::planner
