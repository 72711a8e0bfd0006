// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace specplan::command
{
/// While it lives Ctrl-C (SIGINT) stops the search and leaves what has been found; a second one ends the program, as
/// the first one does before and after. A program that was told to ignore SIGINT goes on doing so.
///
/// Threads: one of it at a time.
class StopOnInterrupt
{
public:
    StopOnInterrupt();
    ~StopOnInterrupt();
    StopOnInterrupt(const StopOnInterrupt&) = delete;
    StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

private:
    struct sigaction before_ = {};
};

/// Whether the user has asked to stop. Threads: any.
[[nodiscard]] bool interrupted();
}  // namespace specplan::command
