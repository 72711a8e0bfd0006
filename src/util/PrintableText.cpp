// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/PrintableText.h"

#include <array>
#include <cstddef>

namespace specplan::util
{
namespace
{
unsigned byteAt(std::string_view text, std::size_t at)
{
    return static_cast<unsigned char>(text[at]);
}

/// Bytes of the character in UTF-8 that begins here; 0 if none does, or a control character.
/// Source: The Unicode Standard, table 3-7.
std::size_t lengthOfCharacter(std::string_view text, std::size_t at)
{
    struct Row
    {
        unsigned first, last;        ///< of the first byte
        unsigned second, secondEnd;  ///< of the second byte; others are 80 to BF
        std::size_t length;
    };
    constexpr std::array<Row, 9> kRows{{{0x20, 0x7E, 0, 0, 1},
                                        {0xC2, 0xC2, 0xA0, 0xBF, 2},  // 80 to 9F are control characters
                                        {0xC3, 0xDF, 0x80, 0xBF, 2},
                                        {0xE0, 0xE0, 0xA0, 0xBF, 3},
                                        {0xE1, 0xEC, 0x80, 0xBF, 3},
                                        {0xED, 0xED, 0x80, 0x9F, 3},
                                        {0xEE, 0xEF, 0x80, 0xBF, 3},
                                        {0xF0, 0xF0, 0x90, 0xBF, 4},
                                        {0xF1, 0xF4, 0x80, 0xBF, 4}}};
    for (const Row& row : kRows)
    {
        if (byteAt(text, at) < row.first || byteAt(text, at) > row.last)
            continue;
        if (row.length == 1)
            return 1;
        const unsigned secondEnd = byteAt(text, at) == 0xF4 ? 0x8F : row.secondEnd;
        if (at + row.length > text.size() || byteAt(text, at + 1) < row.second || byteAt(text, at + 1) > secondEnd)
            return 0;
        for (std::size_t i = 2; i < row.length; ++i)
            if ((byteAt(text, at + i) & 0xC0U) != 0x80U)
                return 0;
        return row.length;
    }
    return 0;
}

std::string escapeOf(unsigned byte)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    if (byte == '\n')
        return "\\n";
    if (byte == '\t')
        return "\\t";
    if (byte == '\r')
        return "\\r";
    return std::string("\\x") + kDigits[byte >> 4U] + kDigits[byte & 15U];
}
}  // namespace

std::string printable(std::string_view text)
{
    std::string out;
    out.reserve(text.size());
    for (std::size_t at = 0; at < text.size();)
    {
        const std::size_t length = lengthOfCharacter(text, at);
        if (length == 0)
            out += escapeOf(byteAt(text, at++));
        else
            out += text.substr(at, length);
        at += length;
    }
    return out;
}

std::string inQuotes(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    if (text.size() <= kMost)
        return '\'' + printable(text) + '\'';
    std::size_t end = kMost;
    while (end > kMost - 4 && (byteAt(text, end) & 0xC0U) == 0x80U)  // not inside a character
        --end;
    return '\'' + printable(text.substr(0, end)) + "...'";
}
}  // namespace specplan::util
