// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <iosfwd>
#include <string>

namespace specplan::command
{
/// Writes a script that completes subcommands, options, their words and files. \param shell "bash" or "zsh".
void writeCompletion(std::ostream& out, const CLI::App& app, const std::string& shell);
}  // namespace specplan::command
