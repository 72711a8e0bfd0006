// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

#include "specplan/util/PrintableText.h"

namespace specplan::problems
{
using util::inQuotes;
using util::printable;

/// All parts one after the other, as `<<` prints them.
template <typename... Parts>
[[nodiscard]] std::string concat(const Parts&... parts)
{
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

/// Bad input, said in one printable line: "FILE:LINE: what was expected, what was found".
class InputError : public std::runtime_error
{
public:
    explicit InputError(const std::string& text) : std::runtime_error(printable(text))
    {
    }

    /// \param line from 1; 0 if the whole file is meant.
    InputError(const std::string& file, std::size_t line, const std::string& text)
        : InputError(line > 0 ? concat(file, ":", line, ": ", text) : concat(file, ": ", text))
    {
    }
};
}  // namespace specplan::problems
