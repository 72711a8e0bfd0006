// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/TextFile.h"

#include <gtest/gtest.h>

#include <string>

#include "TemporaryFolder.h"

namespace specplan::problems
{
namespace
{
using test::complaintOf;
using test::TemporaryFolder;

TEST(LineReader, ReadsLinesOfAnyEnd)
{
    LineReader in("a\r\nb\n\nc", "text");
    std::string line;
    for (const char* expected : {"a", "b", "", "c"})
    {
        ASSERT_TRUE(in.next(line));
        EXPECT_EQ(line, expected);
    }
    EXPECT_FALSE(in.next(line));
    EXPECT_EQ(complaintOf<InputError>([&] { (void)in.expect("more"); }),
              "text:5: expected more, found the end of the file");
}

TEST(ReadText, ReadsPipesAndRefusesWhatHasNoEnd)
{
    const TemporaryFolder folder;
    const std::string large(3'000'001, 'x');
    EXPECT_EQ(readText(folder.write("a", large)), large);
    EXPECT_EQ(complaintOf<InputError>([] { (void)readText("/dev/zero"); }),
              "/dev/zero: expected a file of at most 1 GiB");
    EXPECT_EQ(complaintOf<InputError>([&] { (void)readText(folder / "."); }),
              folder / "." + std::string(": expected a file, found a directory"));
}

TEST(Parse, TakesWholeFiniteNumbersOnly)
{
    int whole = 0;
    double number = 0.0;
    EXPECT_TRUE(parse("-12", whole));
    EXPECT_EQ(whole, -12);
    EXPECT_TRUE(parse("1.5e3", number));
    EXPECT_EQ(number, 1500.0);
    for (const char* bad : {"", " 1", "1 ", "1x", "x", "99999999999"})
        EXPECT_FALSE(parse(bad, whole)) << bad;
    for (const char* bad : {"", "nan", "inf", "1e999", "1.5 ", "0x10"})
        EXPECT_FALSE(parse(bad, number)) << bad;
}

TEST(Split, LeavesEmptyPartsOut)
{
    EXPECT_EQ(split("  a\t b  ", " \t"), (std::vector<std::string_view>{"a", "b"}));
    EXPECT_TRUE(split("", " ").empty());
    EXPECT_TRUE(split("  ", " ").empty());
}

TEST(InputError, IsOnePrintableLine)
{
    EXPECT_STREQ(InputError("a\nb", 3, "found '\x02'").what(), "a\\nb:3: found '\\x02'");
    EXPECT_STREQ(InputError("\x1b[2J").what(), "\\x1b[2J");
}
}  // namespace
}  // namespace specplan::problems
