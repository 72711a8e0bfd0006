// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace specplan::problems
{
/// Looks over a COLLADA file before Assimp gets it, which trusts it: a letter among the indices of a mesh keeps Assimp
/// busy for ever, and an accessor that reaches beyond its array makes it read what is not there.
/// \throws InputError naming the file and the line if there is such a place.
void inspectCollada(const std::string& path, std::string_view text);
}  // namespace specplan::problems
