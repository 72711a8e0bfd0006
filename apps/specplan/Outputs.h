// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace specplan::command
{
/// A file that an option asks for; "-" is standard output.
struct Output
{
    const char* option;
    std::string file;  ///< empty: not asked for
};

/// Looks at all outputs before anything is run. \param inputs files that are read. \param json whether standard output
/// is taken by a JSON object. \throws InputError if one cannot be written, would overwrite an input, or two are one.
void requireOutputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs, bool json);

/// Where tables go: standard output, or standard error if an output takes that.
[[nodiscard]] std::ostream& streamForTables(const std::vector<Output>& outputs, std::ostream& out);

/// Writes an output, as problems::writeFile() does where it is a file. \throws InputError if it is lost.
void writeOutput(const std::string& file, const std::function<void(std::ostream&)>& write);

/// Makes sure that what went to standard output has arrived. \throws InputError if it was lost.
void requireWritten(std::ostream& out);

/// Opens what the shell has closed of standard input, output and error, so that no file gets their numbers; using them
/// goes on being an error.
void keepStandardDescriptors();
}  // namespace specplan::command
