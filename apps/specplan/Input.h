// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace specplan::command
{
/// A file of the command line in memory, so that pipes can be looked at too.
struct Input
{
    std::string name;  ///< what messages and tables call it
    std::string file;  ///< its name in the file system
    std::string text;
};

/// Reads a file; "-" is standard input. \throws InputError naming it.
[[nodiscard]] Input readInput(const std::string& file);
}  // namespace specplan::command
