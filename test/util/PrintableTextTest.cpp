// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/PrintableText.h"

#include <gtest/gtest.h>

namespace specplan::util
{
namespace
{
TEST(Printable, EscapesControlCharactersAndNothingElse)
{
    EXPECT_EQ(printable("plain 'text' \\ with \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80"),
              "plain 'text' \\ with \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80");
    EXPECT_EQ(printable({"\x1b[31m\0\t\n\r\x7f", 10}), "\\x1b[31m\\x00\\t\\n\\r\\x7f");
    EXPECT_EQ(printable("\xC2\x9B"), "\\xc2\\x9b") << "a control character of Latin 1";
}

TEST(Printable, EscapesWhatIsNoUtf8)
{
    EXPECT_EQ(printable("a\x80z"), "a\\x80z");
    EXPECT_EQ(printable("\xC3"), "\\xc3") << "half a character";
    EXPECT_EQ(printable("\xE2\x82"), "\\xe2\\x82");
    EXPECT_EQ(printable("\xC0\xAF"), "\\xc0\\xaf") << "longer than need be";
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "half of a pair of UTF-16";
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond the last character";
}

TEST(Printable, ChangesNothingTwice)
{
    std::string all;
    for (int byte = 0; byte < 256; ++byte)
        all += static_cast<char>(byte);
    const std::string once = printable(all);
    EXPECT_EQ(printable(once), once);
}

TEST(Quoted, CutsLongTextsBetweenCharacters)
{
    EXPECT_EQ(inQuotes("a\tb"), "'a\\tb'");
    EXPECT_EQ(inQuotes(std::string(60, 'x')), '\'' + std::string(60, 'x') + '\'');
    EXPECT_EQ(inQuotes(std::string(61, 'x')), '\'' + std::string(60, 'x') + "...'");
    EXPECT_EQ(inQuotes(std::string(59, 'x') + "\xC3\xA4y"), '\'' + std::string(59, 'x') + "...'");
}
}  // namespace
}  // namespace specplan::util
