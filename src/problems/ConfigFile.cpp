// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/ConfigFile.h"

#include <string_view>

#include "specplan/problems/TextFile.h"

namespace specplan::problems
{
namespace
{
constexpr std::string_view kBlanks = " \t";

std::string_view trimmed(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}
}  // namespace

std::vector<ConfigEntry> readConfigFile(const std::string& path)
{
    LineReader in(path);
    std::vector<ConfigEntry> entries;
    std::string section;
    std::size_t number = 0;
    for (std::string line; in.next(line);)
    {
        ++number;
        const std::string_view text = trimmed(std::string_view(line).substr(0, line.find('#')));
        if (text.empty())
            continue;
        if (text.front() == '[')
        {
            if (text.back() != ']' || text.size() < 3)
                in.fail("expected a section such as [problem], found '", text, "'");
            section = trimmed(text.substr(1, text.size() - 2));
            continue;
        }
        const std::size_t equals = text.find('=');
        if (equals == std::string_view::npos || trimmed(text.substr(0, equals)).empty())
            in.fail("expected 'key = value' or a section, found '", text, "'");
        entries.push_back({section, std::string(trimmed(text.substr(0, equals))),
                           std::string(trimmed(text.substr(equals + 1))), number});
    }
    return entries;
}
}  // namespace specplan::problems
