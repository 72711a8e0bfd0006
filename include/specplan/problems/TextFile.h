// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "specplan/problems/InputError.h"

namespace specplan::problems
{
/// The whole of a file, or of what a pipe or device has. \throws InputError if it cannot be read, is a directory, or
/// has more than 1 GiB.
[[nodiscard]] std::string readText(const std::string& path);

/// The same of a stream. \param name what messages call it.
[[nodiscard]] std::string readText(std::istream& in, const std::string& name);

/// Reads a text line by line and knows where it is, for messages.
class LineReader
{
public:
    /// \throws InputError as readText() does.
    explicit LineReader(const std::string& path);

    /// \param name what messages call it.
    LineReader(std::string text, std::string name);

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
        throw InputError(name_, line_, concat(text...));
    }

private:
    std::string expectLine(const std::string& what);

    std::string text_;
    std::string name_;
    std::size_t at_ = 0;
    std::size_t line_ = 0;
};

/// Parts of a line between separators; empty parts are left out.
[[nodiscard]] std::vector<std::string_view> split(std::string_view line, std::string_view separators);

/// The whole text as a number. \return false if it is not one, or not finite.
[[nodiscard]] bool parse(std::string_view text, int& number);
[[nodiscard]] bool parse(std::string_view text, double& number);
}  // namespace specplan::problems
