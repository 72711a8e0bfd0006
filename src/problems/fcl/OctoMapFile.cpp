// SPDX-License-Identifier: BSD-3-Clause
// Files of OctoMap.
#include <bit>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string_view>

#include <octomap/octomap.h>

#include "specplan/problems/InputError.h"
#include "specplan/problems/OutputFile.h"
#include "specplan/problems/TextFile.h"
#include "specplan/problems/fcl/OctoMap.h"

namespace specplan::problems
{
namespace
{
constexpr std::string_view kBinary = "# Octomap OcTree binary file";
constexpr std::string_view kFull = "# Octomap OcTree file";
constexpr unsigned kDepth = 16;  // of OctoMap's trees below their root

/// What a file says before its voxels.
struct Header
{
    bool binary = false;
    std::string id;
    std::size_t nodes = 0;
    double resolution = 0.0;
    std::size_t length = 0;  ///< in bytes
};

/// Looks over a file from its beginning to its last voxel. OctoMap's reader follows whatever it finds, past the end of
/// the file and deeper than its stack; and it says what it does not like on standard error.
class Inspection
{
public:
    Inspection(const std::string& path, std::string_view text) : path_(path), text_(text)
    {
    }

    /// \throws InputError if OctoMap could not read it.
    Header run()
    {
        Header header = readHeader();
        if (header.id != "OcTree")
            fail("expected a map of class OcTree, found ", inQuotes(header.id));
        if (!(header.resolution > 0.0))
            fail("expected voxels larger than 0, found 'res ", header.resolution, '\'');
        if (header.nodes == 0)
            fail("expected a map with occupied voxels, found an empty one");
        nodes_ = 1;
        if (header.binary)
            passBinaryNode(0);
        else
            passNode(0);
        if (nodes_ != header.nodes)
            fail("expected an OctoMap of ", header.nodes, " nodes as it says, found ", nodes_);
        return header;
    }

private:
    template <typename... Parts>
    [[noreturn]] void fail(const Parts&... text) const
    {
        throw InputError(path_, 0, concat(text...));
    }

    std::string_view line()
    {
        const std::size_t end = text_.find('\n', at_);
        if (end == std::string_view::npos)
            fail("expected an OctoMap file (.bt, .ot), found no whole header");
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1;
        return line;
    }

    Header readHeader()
    {
        Header header;
        header.binary = text_.starts_with(kBinary);
        if (!header.binary && !text_.starts_with(kFull))
            fail("expected an OctoMap file (.bt, .ot), which begins with '", kFull, "' or '", kBinary, '\'');
        for (std::string_view next = line(); !next.starts_with("data"); next = line())
        {
            const std::vector<std::string_view> words = split(next, " \t\r");
            if (words.size() < 2 || words[0].starts_with('#'))
                continue;
            int count = 0;
            if (words[0] == "id")
                header.id = words[1];
            else if (words[0] == "res" && !parse(words[1], header.resolution))
                fail("expected a number as 'res', found ", inQuotes(words[1]));
            else if (words[0] == "size" && (!parse(words[1], count) || count < 0))
                fail("expected a number of nodes as 'size', found ", inQuotes(words[1]));
            else if (words[0] == "size")
                header.nodes = static_cast<std::size_t>(count);
        }
        header.length = at_;
        return header;
    }

    unsigned byte()
    {
        if (at_ == text_.size())
            fail("expected a whole OctoMap, but the file ends after ", nodes_, " nodes");
        return static_cast<unsigned char>(text_[at_++]);
    }

    void requireAbove(unsigned depth) const
    {
        if (depth >= kDepth)
            fail("expected an OctoMap, but voxels lie more than ", kDepth, " levels deep");
    }

    /// Two bits a child: unknown, free, occupied, or with children of its own.
    void passBinaryNode(unsigned depth)
    {
        const unsigned low = byte();
        const unsigned children = low | byte() << 8U;
        if (children != 0)
            requireAbove(depth);
        unsigned inner = 0;
        for (unsigned child = 0; child < 8; ++child)
        {
            const unsigned kind = children >> (2U * child) & 3U;
            nodes_ += kind != 0 ? 1 : 0;
            inner += kind == 3 ? 1 : 0;
        }
        for (; inner > 0; --inner)
            passBinaryNode(depth + 1);
    }

    /// A number, then one bit a child.
    void passNode(unsigned depth)
    {
        for (std::size_t i = 0; i < sizeof(float); ++i)
            byte();
        const auto children = static_cast<unsigned>(std::popcount(byte()));
        if (children > 0)
            requireAbove(depth);
        nodes_ += children;
        for (unsigned child = 0; child < children; ++child)
            passNode(depth + 1);
    }

    const std::string& path_;
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t nodes_ = 0;
};

bool hasOccupiedVoxels(const octomap::OcTree& map)
{
    for (auto leaf = map.begin_leafs(), end = map.end_leafs(); leaf != end; ++leaf)
        if (map.isNodeOccupied(*leaf))
            return true;
    return false;
}
}  // namespace

std::shared_ptr<const octomap::OcTree> readOctoMap(const std::string& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw InputError(path, 0, "expected an OctoMap file (.bt, .ot), found none");
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    if (!file)
        throw InputError(path, 0, "cannot be read");
    const Header header = Inspection(path, text.view()).run();
    // OctoMap's functions for the header tell the user on standard error what they do.
    text.seekg(static_cast<std::streamoff>(header.length));
    const auto map = std::make_shared<octomap::OcTree>(header.resolution);
    if (header.binary)
        map->readBinaryData(text);
    else
        map->readData(text);
    if (!hasOccupiedVoxels(*map))
        throw InputError(path, 0, "expected a map with occupied voxels, found free ones only");
    return map;
}

void writeOctoMap(const std::string& path, const octomap::OcTree& map)
{
    writeFile(path,
              [&map](std::ostream& out)
              {
                  out << kBinary
                      << "\n# (feel free to add / change comments, but leave the first line as it is!)\n#\nid "
                      << map.getTreeType() << "\nsize " << map.size() << "\nres " << map.getResolution() << "\ndata\n";
                  if (map.size() > 0)
                      map.writeBinaryNode(out, map.getRoot());
              });
}
}  // namespace specplan::problems
