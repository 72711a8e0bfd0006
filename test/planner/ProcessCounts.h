// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace specplan::test
{
/// What this process holds, as Linux counts it; all 0 where there is no /proc.
struct ProcessCounts
{
    std::size_t threads = 0;
    std::size_t files = 0;      ///< open file descriptors
    std::size_t kilobytes = 0;  ///< of memory in use (resident)

    [[nodiscard]] static ProcessCounts now()
    {
        ProcessCounts counts;
        std::ifstream status("/proc/self/status");
        for (std::string key; status >> key;)
        {
            if (key == "Threads:")
                status >> counts.threads;
            else if (key == "VmRSS:")
                status >> counts.kilobytes;
        }
        counts.files = entriesOf("/proc/self/fd");
        return counts;
    }

private:
    static std::size_t entriesOf(const char* folder)
    {
        std::error_code error;
        std::size_t entries = 0;
        for (auto entry = std::filesystem::directory_iterator(folder, error);
             !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
            ++entries;
        return entries;
    }
};
}  // namespace specplan::test
