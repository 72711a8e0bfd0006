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

/// Reads a text of sections "[name]" and lines "key = value"; "#" starts a comment. Entries come in the order of the
/// text. \param name what messages call it. \throws InputError naming it and the line.
[[nodiscard]] std::vector<ConfigEntry> parseConfig(std::string text, const std::string& name);
}  // namespace specplan::problems
