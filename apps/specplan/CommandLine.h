// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace specplan::command
{
/// Runs the command. \return the exit status (ExitStatus.h).
[[nodiscard]] int run(int argc, char** argv);
}  // namespace specplan::command
