// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace specplan::test
{
/// A folder of its own for a test, gone at its end.
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "specplan-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("no temporary folder");
        path_ = name;
    }

    ~TemporaryFolder()
    {
        std::filesystem::remove_all(path_);
    }

    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] std::string operator/(const std::string& file) const
    {
        return (path_ / file).string();
    }

    [[nodiscard]] std::string write(const std::string& file, const std::string& text) const
    {
        std::ofstream(path_ / file, std::ios::binary) << text;
        return *this / file;
    }

    [[nodiscard]] std::string read(const std::string& file) const
    {
        std::ostringstream text;
        text << std::ifstream(path_ / file, std::ios::binary).rdbuf();
        return text.str();
    }

    [[nodiscard]] std::ptrdiff_t files() const
    {
        return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
    }

private:
    std::filesystem::path path_;
};

/// What `action` complains about; empty if it does not.
template <typename Error, typename Action>
std::string complaintOf(const Action& action)
{
    try
    {
        action();
    }
    catch (const Error& error)
    {
        return error.what();
    }
    return {};
}
}  // namespace specplan::test
