// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::command
{
/// A line on the terminal that shows how far a search is, once it has taken two seconds. Nothing where standard error
/// is no terminal.
///
/// Threads: that of solve(), which `tick` is called from.
class Progress
{
public:
    /// \param planner must outlive this.
    Progress(const SpeculativeAStar& planner, const std::string& problem, const PlannerSettings& settings);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void tick();

private:
    void show();

    using Clock = std::chrono::steady_clock;

    const SpeculativeAStar& planner_;
    std::string title_;
    bool enabled_;
    bool shown_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_;
};
}  // namespace specplan::command
