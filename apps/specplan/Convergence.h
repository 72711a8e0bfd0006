// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>

namespace specplan::command
{
/// How the cost of a planner's best path fell while it planned.
///
/// Threads: the one that the planner asks its termination condition in; the values may be read after that.
class Convergence
{
public:
    /// A path became the best.
    struct Point
    {
        double time;  ///< seconds after begin(), at most kInterval late while the planner goes on
        double cost;
    };

    /// A planner is asked for its cost no more often than this, in seconds.
    static constexpr double kInterval = 1e-3;

    /// Optimizing planners tell their cost as progress property "best cost"; of others only the end is known.
    explicit Convergence(const ompl::base::Planner& planner);

    void begin();

    /// To be called often while the planner runs, from the thread it runs in.
    void look();

    /// To be called after solve(). \param problem the problem definition with the planner's path, if it found one.
    void end(const ompl::base::ProblemDefinition& problem);

    /// Costs of exact paths, falling; empty if none was found.
    [[nodiscard]] const std::vector<Point>& points() const noexcept
    {
        return points_;
    }

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] double elapsed() const;
    void add(double cost);

    ompl::base::Planner::PlannerProgressProperty bestCost_;  ///< empty if the planner has none
    Clock::time_point begin_;
    double next_ = 0.0;  ///< time of the next look
    std::vector<Point> points_;
};
}  // namespace specplan::command
