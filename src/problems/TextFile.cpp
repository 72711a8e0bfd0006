// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/TextFile.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "specplan/util/ParseNumber.h"

namespace specplan::problems
{
std::string readText(const std::string& path)
{
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw InputError(path, 0, "expected a file, found a directory");
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw InputError(path, 0, "cannot be read: no such file, or no permission");
    return readText(in, path);
}

std::string readText(std::istream& in, const std::string& name)
{
    constexpr std::size_t kMost = std::size_t{1} << 30U;
    constexpr std::size_t kPiece = std::size_t{1} << 20U;
    std::string text;
    while (in)
    {
        const std::size_t size = text.size();
        if (size > kMost)
            throw InputError(name, 0, "expected a file of at most 1 GiB");
        text.resize(size + kPiece);
        in.read(text.data() + size, kPiece);
        text.resize(size + static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad())
        throw InputError(name, 0, "cannot be read to its end");
    return text;
}

LineReader::LineReader(const std::string& path) : LineReader(readText(path), path)
{
}

LineReader::LineReader(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name))
{
}

bool LineReader::next(std::string& line)
{
    if (at_ == text_.size())
        return false;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    line.assign(text_, at_, end - at_);
    at_ = std::min(end + 1, text_.size());
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
}  // namespace specplan::problems
