// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
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
/// Says on the terminal how many searches or runs there are, and which one is on. Nothing where standard error is no
/// terminal.
class SeriesProgress
{
public:
    /// \param one, many what they are called.
    SeriesProgress(std::string one, const std::string& many, std::size_t count);
    ~SeriesProgress();
    SeriesProgress(const SeriesProgress&) = delete;
    SeriesProgress& operator=(const SeriesProgress&) = delete;

    /// The next one begins. \param name of it; empty for none.
    void begin(const std::string& name = {});

    /// Leaves the terminal's line to others, until the next one begins.
    void clear() const;

private:
    std::string one_;
    std::size_t count_;
    std::size_t current_ = 0;
    bool enabled_;
};
}  // namespace specplan::command
