// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "specplan/problems/InputError.h"

namespace specplan::fuzz
{
[[noreturn]] inline void fail(std::string_view what, std::string_view about)
{
    std::fprintf(stderr, "fuzzer: %.*s: %.*s\n", static_cast<int>(what.size()), what.data(),
                 static_cast<int>(about.size()), about.data());
    std::abort();
}

/// A message for the user is one line, without bytes that a terminal would obey.
inline void requireOneLine(std::string_view message)
{
    if (message.empty())
        fail("a message is empty", "");
    for (const char c : message)
        if (const auto byte = static_cast<unsigned char>(c); byte < 0x20 || byte == 0x7F)
            fail("a message has control bytes", message);
}

/// A file in memory that holds the input.
class InputFile
{
public:
    InputFile() : file_(memfd_create("input", 0)), path_("/proc/self/fd/" + std::to_string(file_))
    {
        if (file_ < 0)
            fail("cannot make a file in memory", "");
    }

    const std::string& write(const std::uint8_t* data, std::size_t size)
    {
        if (ftruncate(file_, 0) != 0 || pwrite(file_, data, size, 0) != static_cast<ssize_t>(size))
            fail("cannot write the file in memory", path_);
        return path_;
    }

private:
    int file_;
    std::string path_;
};

/// Lets a reader read the input. What is wrong with it has to be said by an InputError of one line; any other exception
/// ends the fuzzer.
template <typename Reader>
int readInput(const std::uint8_t* data, std::size_t size, Reader reader)
{
    static InputFile file;
    try
    {
        reader(file.write(data, size));
    }
    catch (const problems::InputError& error)
    {
        requireOneLine(error.what());
    }
    return 0;
}
}  // namespace specplan::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
