// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace specplan::problems
{
/// Bad input, said in one line: "FILE:LINE: what was expected, what was found".
class InputError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;

    /// \param line from 1; 0 if the whole file is meant.
    InputError(const std::string& file, std::size_t line, const std::string& text)
        : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : std::string()) + ": " + text)
    {
    }
};
}  // namespace specplan::problems
