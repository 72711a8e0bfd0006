// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "specplan/problems/InputError.h"

namespace specplan::problems
{
/// Reads a text file line by line and knows where it is, for messages.
class LineReader
{
public:
    /// \throws InputError if the file cannot be read.
    explicit LineReader(std::string path);

    /// Next line without its end ("\n" or "\r\n"); false at the end of the file.
    bool next(std::string& line);

    /// Next line. \throws InputError that says what was expected, at the end of the file.
    template <typename... Parts>
    std::string expect(const Parts&... what)
    {
        return expectLine(concat(what...));
    }

    /// An InputError at the line read last.
    template <typename... Parts>
    [[noreturn]] void fail(const Parts&... text) const
    {
        throw InputError(path_, line_, concat(text...));
    }

private:
    std::string expectLine(const std::string& what);

    std::string path_;
    std::ifstream in_;
    std::size_t line_ = 0;
};

/// Parts of a line between separators; empty parts are left out.
[[nodiscard]] std::vector<std::string_view> split(std::string_view line, std::string_view separators);

/// The whole text as a number. \return false if it is not one, or not finite.
[[nodiscard]] bool parse(std::string_view text, int& number);
[[nodiscard]] bool parse(std::string_view text, double& number);

/// Writes a file all or nothing: to a temporary beside it that takes its name at the end.
/// \throws InputError if that cannot be done; the old file, if any, is then as it was.
void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write);

/// \throws InputError if `writeFile` would not be able to write there.
void requireWritable(const std::string& path);
}  // namespace specplan::problems
