// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace specplan::command
{
/// Runs the command. \return the exit status: 0 solved, 1 not solved, 2 bad usage or input.
[[nodiscard]] int run(int argc, char** argv);
}  // namespace specplan::command
