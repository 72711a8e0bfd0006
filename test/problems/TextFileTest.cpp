// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/TextFile.h"

#include <gtest/gtest.h>

#include <ostream>
#include <stdexcept>

#include "TemporaryFolder.h"

namespace specplan::problems
{
namespace
{
using test::complaintOf;
using test::TemporaryFolder;

TEST(WriteFile, WritesAllOrNothing)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a.txt", "old");
    EXPECT_THROW(writeFile(file,
                           [](std::ostream& out)
                           {
                               out << "half";
                               throw std::runtime_error("stop");
                           }),
                 std::runtime_error);
    EXPECT_EQ(folder.read("a.txt"), "old");
    EXPECT_EQ(folder.files(), 1) << "nothing half-written is left";
    writeFile(file, [](std::ostream& out) { out << "new"; });
    EXPECT_EQ(folder.read("a.txt"), "new");
    EXPECT_EQ(folder.files(), 1);
}

TEST(WriteFile, NamesAPlaceThatCannotBeWritten)
{
    const TemporaryFolder folder;
    const std::string file = folder / "none/a.txt";
    const auto write = [&] { writeFile(file, [](std::ostream& out) { out << "x"; }); };
    EXPECT_EQ(complaintOf<InputError>(write), file + ": cannot be written");
}

TEST(RequireWritable, ChecksWithoutATrace)
{
    const TemporaryFolder folder;
    EXPECT_NO_THROW(requireWritable(folder / "a.txt"));
    EXPECT_EQ(folder.files(), 0);
    const std::string there = folder.write("b.txt", "old");
    EXPECT_NO_THROW(requireWritable(there));
    EXPECT_EQ(folder.read("b.txt"), "old");
    EXPECT_THROW(requireWritable(folder / "none/a.txt"), InputError);
    EXPECT_EQ(complaintOf<InputError>([&] { requireWritable(folder / "."); }),
              folder / "." + std::string(": cannot be written: it is a directory"));
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
}  // namespace
}  // namespace specplan::problems
