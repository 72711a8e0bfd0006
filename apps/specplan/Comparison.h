// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace specplan::command
{
/// What two runs of one problem are compared by.
struct RunRecord
{
    std::string status;
    bool stopped = false;  ///< by a limit or the user
    std::uint64_t orderHash = 0;
    std::vector<std::uint64_t> expansions;  ///< a hash of each expanded state, in order
    std::vector<double> costs;              ///< of the paths that were found, in order
    std::vector<std::vector<double>> path;  ///< empty if there is none
};

/// How a run differs from the sequential one, as one line; empty if it does not. Where one of them was stopped, what
/// both did is compared: expansions and costs up to the end of the shorter one.
[[nodiscard]] std::string differenceOf(const RunRecord& run, const RunRecord& sequential);
}  // namespace specplan::command
