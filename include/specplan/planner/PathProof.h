// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

namespace specplan::planner
{
/// Checks a path once more, as PathGeometric::check() would, before it is called exact: over a state space of the
/// user's own class a copy of a state may be worth less than the state that was checked.
///
/// Threads: search thread only, while no worker runs.
class PathProof
{
public:
    using Path = std::shared_ptr<ompl::geometric::PathGeometric>;

    PathProof(const ompl::base::SpaceInformation& si, Path path);

    /// Goes on where the last call stopped. \param stop asked before each state; a motion validator of the user's own
    /// takes a whole motion. \return whether the proof is complete; false if `stop` said so.
    [[nodiscard]] bool run(const std::function<bool()>& stop);

    [[nodiscard]] const Path& path() const noexcept
    {
        return path_;
    }

    /// One line that names what is not valid; empty if nothing is.
    [[nodiscard]] const std::string& fault() const noexcept
    {
        return fault_;
    }

    /// States checked so far; a motion that the user's own validator checks counts as one.
    [[nodiscard]] std::uint64_t checks() const noexcept
    {
        return checks_;
    }

private:
    [[nodiscard]] bool checkNext();

    const ompl::base::SpaceInformation& si_;
    Path path_;
    bool discrete_;
    std::size_t state_ = 0;  ///< to be checked next, and then the motion into it
    unsigned inner_ = 0;     ///< of that motion; 0 for the state itself
    std::uint64_t checks_ = 0;
    std::string fault_;
};

/// Makes sure that a state that the planner wrote is as good as the valid state whose values it has: that a copy of it
/// is valid, and what OMPL makes by going half of the way from one to the other. Two checks.
/// \throws ompl::Exception with one line that says what is missing.
void requireComplete(const ompl::base::SpaceInformation& si, const ompl::base::State* written,
                     const ompl::base::State* valid);
}  // namespace specplan::planner
