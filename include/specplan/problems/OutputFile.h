// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace specplan::problems
{
/// Writes a file. Links are followed. A file that is new, or regular and without other names, is written all or
/// nothing: to a temporary beside it that takes its name at the end; permissions and owner stay. Devices, pipes and
/// what else cannot be replaced are opened and written, as is a file in a folder where nothing may be added. \throws
/// InputError naming the file and the reason if that cannot be done.
void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write);

/// \throws InputError if `writeFile` would not be able to write there. Leaves no trace.
void requireWritable(const std::string& path);

/// Whether both names stand for one file, pipe or socket, there or yet to be written. Devices such as /dev/null never
/// are: what is written to them does not get in each other's way.
[[nodiscard]] bool isSameFile(const std::string& a, const std::string& b);
}  // namespace specplan::problems
