// SPDX-License-Identifier: BSD-3-Clause
#include "Outputs.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iostream>
#include <string_view>
#include <system_error>

#include "specplan/problems/InputError.h"
#include "specplan/problems/OutputFile.h"

namespace specplan::command
{
using problems::concat;
using problems::InputError;

namespace
{
bool isStandardOutput(const std::string& file)
{
    constexpr std::array<std::string_view, 4> kNames{"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};
    return std::ranges::find(kNames, file) != kNames.end();
}

std::string openableName(const Output& output)
{
    return isStandardOutput(output.file) ? "/dev/stdout" : output.file;
}

void requireFree(const Output& output, const std::vector<std::string>& inputs, bool json)
{
    if (isStandardOutput(output.file) && json)
        throw InputError(concat(output.option, " ", output.file, ": expected a file; --json takes standard output"));
    if (!isStandardOutput(output.file) && problems::isSameFile(output.file, "/dev/stdout"))
        throw InputError(concat(output.option, ": ", output.file,
                                " is where standard output goes; expected another file, or - to write there"));
    for (const std::string& input : inputs)
        if (problems::isSameFile(openableName(output), input))
            throw InputError(concat(output.option, ": ", output.file, " is an input; expected another file"));
}
}  // namespace

void requireOutputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs, bool json)
{
    std::vector<Output> wanted;
    std::ranges::copy_if(outputs, std::back_inserter(wanted),
                         [](const Output& output) { return !output.file.empty(); });
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        if (!isStandardOutput(wanted[i].file))
            problems::requireWritable(wanted[i].file);
        requireFree(wanted[i], inputs, json);
        for (std::size_t j = 0; j < i; ++j)
            if ((isStandardOutput(wanted[i].file) && isStandardOutput(wanted[j].file)) ||
                problems::isSameFile(openableName(wanted[i]), openableName(wanted[j])))
                throw InputError(concat(wanted[j].option, " and ", wanted[i].option, ": expected two files, found ",
                                        wanted[i].file, " for both"));
    }
}

std::ostream& streamForTables(const std::vector<Output>& outputs, std::ostream& out)
{
    const bool taken = std::ranges::any_of(outputs, [](const Output& output) { return isStandardOutput(output.file); });
    return taken ? std::cerr : out;
}

void writeOutput(const std::string& file, const std::function<void(std::ostream&)>& write)
{
    if (!isStandardOutput(file))
    {
        problems::writeFile(file, write);
        return;
    }
    write(std::cout);
    requireWritten(std::cout);
}

void requireWritten(std::ostream& out)
{
    errno = 0;
    if (out && out.flush())
        return;
    const int reason = errno;
    throw InputError(concat("standard output: cannot be written",
                            reason != 0 ? ": " + std::generic_category().message(reason) : ""));
}

void keepStandardDescriptors()
{
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) == -1)
        {
            // The lowest number that is free is this one. The wrong direction keeps every use of it an error.
            const int opened = open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
            static_cast<void>(opened);
        }
}
}  // namespace specplan::command
