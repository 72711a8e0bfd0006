// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/TextFile.h"

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "specplan/util/ParseNumber.h"

namespace specplan::problems
{
namespace
{
std::string temporaryName(const std::string& path)
{
    return concat(path, ".part");
}
}  // namespace

LineReader::LineReader(std::string path) : path_(std::move(path))
{
    std::error_code error;
    if (std::filesystem::is_directory(path_, error))
        throw InputError(path_, 0, "expected a file, found a directory");
    in_.open(path_, std::ios::binary);
    if (!in_)
        throw InputError(path_, 0, "cannot be read: no such file, or no permission");
}

bool LineReader::next(std::string& line)
{
    if (!std::getline(in_, line))
        return false;
    ++line_;
    if (!line.empty() && line.back() == '\r')
        line.pop_back();
    return true;
}

std::string LineReader::expectLine(const std::string& what)
{
    std::string line;
    if (!next(line))
    {
        ++line_;
        fail("expected ", what, ", found the end of the file");
    }
    return line;
}

std::vector<std::string_view> split(std::string_view line, std::string_view separators)
{
    std::vector<std::string_view> parts;
    for (std::size_t at = line.find_first_not_of(separators); at != std::string_view::npos;)
    {
        const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
        parts.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(separators, end);
    }
    return parts;
}

bool parse(std::string_view text, int& number)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
}

bool parse(std::string_view text, double& number)
{
    return util::parseNumber(text, number);
}

void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write)
{
    const std::string temporary = temporaryName(path);
    bool written = false;
    try
    {
        if (std::ofstream out(temporary, std::ios::binary); out)
        {
            write(out);
            out.flush();
            written = static_cast<bool>(out);
        }
    }
    catch (...)
    {
        std::remove(temporary.c_str());
        throw;
    }
    if (!written || std::rename(temporary.c_str(), path.c_str()) != 0)
    {
        std::remove(temporary.c_str());
        throw InputError(path, 0, "cannot be written");
    }
}

void requireWritable(const std::string& path)
{
    std::error_code error;
    const bool directory = std::filesystem::is_directory(path, error);
    const std::string temporary = temporaryName(path);
    const bool writable = !directory && static_cast<bool>(std::ofstream(temporary));
    std::remove(temporary.c_str());
    if (!writable)
        throw InputError(path, 0, directory ? "cannot be written: it is a directory" : "cannot be written");
}
}  // namespace specplan::problems
