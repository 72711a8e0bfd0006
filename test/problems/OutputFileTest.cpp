// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/OutputFile.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <filesystem>
#include <future>
#include <ostream>
#include <stdexcept>

#include "TemporaryFolder.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace
{
namespace fs = std::filesystem;
using test::complaintOf;
using test::TemporaryFolder;

void writeText(const std::string& file, const std::string& text)
{
    writeFile(file, [&text](std::ostream& out) { out << text; });
}

unsigned modeOf(const std::string& file)
{
    struct stat status = {};
    EXPECT_EQ(stat(file.c_str(), &status), 0) << file;
    return status.st_mode;
}

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
    writeText(file, "new");
    EXPECT_EQ(folder.read("a.txt"), "new");
    EXPECT_EQ(folder.files(), 1);
}

TEST(WriteFile, WritesMoreThanABuffer)
{
    const TemporaryFolder folder;
    const std::string text(1'000'000, 'x');
    writeText(folder / "a.txt", text);
    EXPECT_EQ(folder.read("a.txt"), text);
}

TEST(WriteFile, NamesAPlaceThatCannotBeWritten)
{
    const TemporaryFolder folder;
    const std::string file = folder / "none/a.txt";
    EXPECT_EQ(complaintOf<InputError>([&] { writeText(file, "x"); }),
              file + ": cannot be written: No such file or directory");
    EXPECT_EQ(complaintOf<InputError>([&] { writeText(folder / ".", "x"); }),
              folder / "." + std::string(": cannot be written: it is a directory"));
}

TEST(WriteFile, AFullDiskIsAnError)
{
    if (!fs::is_character_file("/dev/full"))
        GTEST_SKIP() << "this system has no /dev/full";
    EXPECT_EQ(complaintOf<InputError>([] { writeText("/dev/full", "x"); }),
              "/dev/full: cannot be written: No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(WriteFile, KeepsPermissions)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a.txt", "old");
    for (const unsigned mode : {0600U, 0640U, 0755U})
    {
        ASSERT_EQ(chmod(file.c_str(), mode), 0);
        writeText(file, "new");
        EXPECT_EQ(modeOf(file) & 07777U, mode);
    }
    const mode_t before = umask(027);
    writeText(folder / "b.txt", "new");
    umask(before);
    EXPECT_EQ(modeOf(folder / "b.txt") & 07777U, 0640U) << "as the user's mask says";
}

TEST(WriteFile, FollowsLinks)
{
    const TemporaryFolder folder;
    fs::create_directory(folder / "there");
    const std::string real = folder.write("there/real", "old");
    fs::create_symlink("there/real", folder / "link");
    fs::create_symlink("link", folder / "link of link");
    writeText(folder / "link of link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link of link"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(folder.read("there/real"), "new");

    fs::create_symlink("there/none yet", folder / "dangling");
    writeText(folder / "dangling", "made");
    EXPECT_TRUE(fs::is_symlink(folder / "dangling"));
    EXPECT_EQ(folder.read("there/none yet"), "made");

    fs::create_symlink("round", folder / "round");
    EXPECT_NE(complaintOf<InputError>([&] { writeText(folder / "round", "x"); }).find("round: cannot be written: "),
              std::string::npos);
}

TEST(WriteFile, KeepsTheOtherNamesOfAFile)
{
    const TemporaryFolder folder;
    fs::create_hard_link(folder.write("a", "old and longer"), folder / "b");
    writeText(folder / "a", "new");
    EXPECT_EQ(folder.read("b"), "new");
    EXPECT_EQ(fs::hard_link_count(folder / "a"), 2U);
}

TEST(WriteFile, FillsPipes)
{
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_NO_THROW(requireWritable(pipe));
    const std::string text(200'000, 'x');
    std::future<std::string> read = std::async(std::launch::async, [&folder] { return folder.read("pipe"); });
    writeText(pipe, text);
    EXPECT_EQ(read.get(), text);
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(folder.files(), 1);
}

TEST(WriteFile, LeavesDevicesWhatTheyAre)
{
    const TemporaryFolder folder;
    const std::string null = folder / "null";
    // Only root may make devices; everybody may have a link to one.
    if (mknod(null.c_str(), S_IFCHR | 0666, makedev(1, 3)) != 0)
        fs::create_symlink("/dev/null", null);
    const auto before = fs::symlink_status(null).type();
    writeText(null, "gone");
    EXPECT_EQ(fs::symlink_status(null).type(), before);
    EXPECT_TRUE(fs::is_character_file(null));
    EXPECT_EQ(folder.files(), 1);
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

TEST(IsSameFile, KnowsAFileByAllItsNames)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a", "x");
    fs::create_symlink("a", folder / "link");
    fs::create_hard_link(file, folder / "twin");
    for (const char* name : {"a", "./a", "link", "twin"})
        EXPECT_TRUE(isSameFile(file, folder / name)) << name;
    EXPECT_TRUE(isSameFile(folder / "none", folder / "./none"));
    EXPECT_TRUE(isSameFile("nothing of this name", "./nothing of this name"));
    EXPECT_FALSE(isSameFile(file, folder / "none"));
    EXPECT_FALSE(isSameFile(file, folder.write("b", "x")));
    EXPECT_FALSE(isSameFile("/dev/null", "/dev/null")) << "what goes there is gone anyway";
}
}  // namespace
}  // namespace specplan::problems
