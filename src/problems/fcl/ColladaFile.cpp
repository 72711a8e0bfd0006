// SPDX-License-Identifier: BSD-3-Clause
#include "ColladaFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "specplan/problems/InputError.h"
#include "specplan/problems/TextFile.h"

namespace specplan::problems
{
namespace
{
constexpr std::string_view kBlanks = " \t\r\n";

/// Goes through the elements in their order; no more of XML than that takes.
class Inspection
{
public:
    Inspection(const std::string& path, std::string_view text) : path_(path), text_(text)
    {
    }

    void run()
    {
        for (std::size_t at = text_.find('<'); at != std::string_view::npos; at = text_.find('<', at))
        {
            if (text_.substr(at).starts_with("<!--"))
            {
                at = std::min(text_.find("-->", at), text_.size());
                continue;
            }
            const std::size_t end = text_.find('>', at);
            if (end == std::string_view::npos)
                break;
            lookAt(text_.substr(at + 1, end - at - 1), end + 1);
            at = end;
        }
        for (const Accessor& accessor : accessors_)
            requireInside(accessor);
    }

private:
    struct Accessor
    {
        std::string source;
        std::uint64_t count;
        std::uint64_t stride;
        std::uint64_t offset;
        std::size_t at;
    };

    template <typename... Parts>
    [[noreturn]] void failAt(std::size_t at, const Parts&... text) const
    {
        const auto lines = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        throw InputError(path_, static_cast<std::size_t>(lines) + 1, concat(text...));
    }

    /// \param tag what is between < and >. \param content where the element's text begins.
    void lookAt(std::string_view tag, std::size_t content)
    {
        constexpr std::array<std::string_view, 5> kLists{"p", "v", "vcount", "h", "ph"};
        const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/"));
        if (std::ranges::find(kLists, name) != kLists.end() && !tag.ends_with('/'))
            requireWholeNumbers(name, content);
        else if (name == "float_array")
            arrays_[attribute(tag, "id").value_or("")] = number(tag, "count", 0, content);
        else if (name == "accessor")
            accessors_.push_back({attribute(tag, "source").value_or(""), number(tag, "count", 0, content),
                                  number(tag, "stride", 1, content), number(tag, "offset", 0, content), content});
    }

    static std::optional<std::string> attribute(std::string_view tag, std::string_view name)
    {
        for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1))
        {
            std::size_t next = tag.find_first_not_of(kBlanks, at + name.size());
            const bool whole = kBlanks.find(tag[at - 1]) != std::string_view::npos;  // the tag's name comes before
            if (!whole || next == std::string_view::npos || tag[next] != '=')
                continue;
            next = tag.find_first_not_of(kBlanks, next + 1);
            if (next == std::string_view::npos || (tag[next] != '"' && tag[next] != '\''))
                return std::nullopt;
            const std::size_t end = tag.find(tag[next], next + 1);
            return std::string(tag.substr(next + 1, end == std::string_view::npos ? end : end - next - 1));
        }
        return std::nullopt;
    }

    std::uint64_t number(std::string_view tag, std::string_view name, std::uint64_t missing, std::size_t at) const
    {
        const auto text = attribute(tag, name);
        if (!text)
            return missing;
        std::uint32_t value = 0;
        const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
        if (error != std::errc{} || end != text->data() + text->size())
            failAt(at, "expected a mesh, but its ", name, " is ", inQuotes(*text), ", not a whole number");
        return value;
    }

    void requireWholeNumbers(std::string_view name, std::size_t at) const
    {
        const std::string_view list = text_.substr(at, text_.find('<', at) - at);
        const std::size_t bad = list.find_first_not_of("0123456789- \t\r\n");
        if (bad == std::string_view::npos)
            return;
        const std::size_t begin = list.find_last_of(kBlanks, bad) + 1;
        const std::string_view word = list.substr(begin, list.find_first_of(kBlanks, bad) - begin);
        failAt(at + bad, "expected a mesh, but <", name, "> has ", inQuotes(word), " among its whole numbers");
    }

    void requireInside(const Accessor& accessor) const
    {
        const auto found = arrays_.find(accessor.source.starts_with('#') ? accessor.source.substr(1) : accessor.source);
        if (found == arrays_.end())
            return;  // of names, or none: Assimp says so
        const std::uint64_t reach = accessor.count == 0 ? 0 : accessor.offset + accessor.count * accessor.stride;
        if (reach > found->second)
            failAt(accessor.at, "expected a mesh, but an accessor reaches to number ", reach, " of an array of ",
                   found->second);
    }

    const std::string& path_;
    std::string_view text_;
    std::map<std::string, std::uint64_t> arrays_;  ///< how many numbers each has
    std::vector<Accessor> accessors_;
};
}  // namespace

void inspectCollada(const std::string& path, std::string_view text)
{
    Inspection(path, text).run();
}
}  // namespace specplan::problems
