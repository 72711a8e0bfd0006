// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace specplan::problems
{
/// One "key = value" of a configuration file.
struct ConfigEntry
{
    std::string section;  ///< empty before the first section
    std::string key;
    std::string value;
    std::size_t line;  ///< from 1
};

/// Reads a file of sections "[name]" and lines "key = value"; "#" starts a comment. Entries come in the order of the
/// file. \throws InputError naming file and line.
[[nodiscard]] std::vector<ConfigEntry> readConfigFile(const std::string& path);
}  // namespace specplan::problems
