// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include <unistd.h>

#include <iostream>
#include <utility>

#include "Text.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
namespace
{
constexpr std::chrono::seconds kQuiet{2};
constexpr std::chrono::milliseconds kInterval{200};
}  // namespace

Progress::Progress(const SpeculativeAStar& planner, const std::string& problem, const PlannerSettings& settings)
    : planner_(planner),
      title_(problems::concat(
          problems::printable(problem), ", ", settings.numThreads == 1 ? "sequential" : settings.speculationPolicy,
          ", ", settings.numThreads == 0 ? "all cores" : problems::concat(settings.numThreads, " threads"))),
      enabled_(isatty(STDERR_FILENO) == 1),
      next_(begin_ + kQuiet)
{
}

Progress::~Progress()
{
    if (shown_)
        std::cerr << "\r\033[K" << std::flush;
}

void Progress::tick()
{
    if (enabled_ && Clock::now() >= next_)
        show();
}

void Progress::show()
{
    std::cerr << "\r\033[K" << title_ << ": "
              << durationText(std::chrono::duration<double>(Clock::now() - begin_).count());
    for (const auto& [name, value] : planner_.getPlannerProgressProperties())
        if (const auto type = name.rfind(" INTEGER"); type != std::string::npos)
            std::cerr << ", " << value() << ' ' << name.substr(0, type);
    std::cerr << std::flush;
    shown_ = true;
    next_ = Clock::now() + kInterval;
}

SeriesProgress::SeriesProgress(std::string one, const std::string& many, std::size_t count)
    : one_(std::move(one)), count_(count), enabled_(isatty(STDERR_FILENO) == 1 && count > 1)
{
    if (enabled_)
        std::cerr << "specplan: " << count_ << ' ' << many << "; Ctrl-C keeps what is finished\n";
}

SeriesProgress::~SeriesProgress()
{
    clear();
}

void SeriesProgress::begin(const std::string& name)
{
    ++current_;
    clear();
    if (enabled_)
        std::cerr << one_ << ' ' << current_ << " of " << count_ << (name.empty() ? "" : ": ") << name << std::flush;
}

void SeriesProgress::clear() const
{
    if (enabled_)
        std::cerr << "\r\033[K" << std::flush;
}
}  // namespace specplan::command
