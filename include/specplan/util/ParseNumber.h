// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <version>

namespace specplan::util
{
/// The same as `parseNumber` for standard libraries that have no std::from_chars for floating point (libc++ before 20).
[[nodiscard]] inline bool parseNumberByStream(std::string_view text, double& number)
{
    // A stream also takes blanks, a plus and, depending on the library, hexadecimal digits.
    if (text.empty() || text.front() == '+' || text.find_first_not_of("0123456789+-.eE") != std::string_view::npos)
        return false;
    std::istringstream in{std::string(text)};
    in.imbue(std::locale::classic());
    double read = 0.0;
    if (!(in >> read) || in.peek() != std::istringstream::traits_type::eof() || !std::isfinite(read))
        return false;
    const std::string_view digits = text.substr(0, text.find_first_of("eE"));
    if (read == 0.0 && digits.find_first_of("123456789") != std::string_view::npos)
        return false;  // too small for a double
    number = read;
    return true;
}

/// The whole text as a decimal number with a point, whatever the locale; no blanks, no leading plus.
/// \return false, and `number` is as it was, if it is not one, or not finite.
[[nodiscard]] inline bool parseNumber(std::string_view text, double& number)
{
#if defined(__cpp_lib_to_chars)
    double read = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(read))
        return false;
    number = read;
    return true;
#else
    return parseNumberByStream(text, number);
#endif
}
}  // namespace specplan::util
