// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace specplan::util
{
/// A text as a terminal may show it, on one line: control characters and bytes that are not UTF-8 become "\n", "\t",
/// "\r" or "\xNN"; all else stays. A printable text stays as it is.
[[nodiscard]] std::string printable(std::string_view text);

/// A piece of a file for messages: printable, in single quotes, and cut after 60 bytes.
[[nodiscard]] std::string inQuotes(std::string_view text);
}  // namespace specplan::util
