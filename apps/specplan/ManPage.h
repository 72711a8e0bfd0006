// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <iosfwd>

namespace specplan::command
{
/// Writes the manual page, section 1, for man(7)'s macros.
void writeManPage(std::ostream& out, const CLI::App& app);
}  // namespace specplan::command
