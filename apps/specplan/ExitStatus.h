// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace specplan::command
{
/// What the command returns to its shell.
enum ExitStatus : int
{
    kSolved = 0,
    kNotSolved = 1,
    kBadInput = 2,
    kOwnFault = 3,
    kInterrupted = 130  ///< as shells have it: 128 and the number of SIGINT
};

/// The same for people: --help and the manual page show this.
constexpr const char* kExitStatusText =
    "Exit status:\n"
    "  0    solved\n"
    "  1    not solved: no path on the lattice, or the time was up\n"
    "  2    bad usage or input, or an output that could not be written; one line on standard error says what\n"
    "  3    a fault of specplan's own: out of memory, or two runs differ that must not (please report it)\n"
    "  130  stopped by Ctrl-C";
}  // namespace specplan::command
