// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/ConfigFile.h"

#include <string_view>
#include <utility>

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

std::vector<ConfigEntry> parseConfig(std::string text, const std::string& name)
{
    LineReader in(std::move(text), name);
    std::vector<ConfigEntry> entries;
    std::string section;
    std::size_t number = 0;
    for (std::string line; in.next(line);)
    {
        ++number;
        const std::string_view content = trimmed(std::string_view(line).substr(0, line.find('#')));
        if (content.empty())
            continue;
        if (content.front() == '[')
        {
            if (content.back() != ']' || content.size() < 3)
                in.fail("expected a section such as [problem], found ", inQuotes(content));
            section = trimmed(content.substr(1, content.size() - 2));
            continue;
        }
        const std::size_t equals = content.find('=');
        if (equals == std::string_view::npos || trimmed(content.substr(0, equals)).empty())
            in.fail("expected 'key = value' or a section, found ", inQuotes(content));
        entries.push_back({section, std::string(trimmed(content.substr(0, equals))),
                           std::string(trimmed(content.substr(equals + 1))), number});
    }
    return entries;
}
}  // namespace specplan::problems
