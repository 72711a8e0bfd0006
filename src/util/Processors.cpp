// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/Processors.h"

#if defined(__linux__)
#include <sched.h>
#endif

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

namespace specplan::util
{
namespace
{
std::string contentOf(const std::string& path)
{
    std::ifstream file(path);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

std::optional<unsigned> least(std::optional<unsigned> a, std::optional<unsigned> b)
{
    return a && b ? std::min(a, b) : a ? a : b;
}

std::optional<unsigned> fromTimes(const std::string& quota, const std::string& period)
{
    std::istringstream text(quota + ' ' + period);
    long long time = 0;
    long long of = 0;
    if (!(text >> time >> of) || time <= 0 || of <= 0)
        return std::nullopt;
    constexpr long long kMost = std::numeric_limits<int>::max();
    return static_cast<unsigned>(std::min(time / of + (time % of != 0 ? 1 : 0), kMost));
}

/// Quota of one group.
std::optional<unsigned> ofFolder(const std::string& folder)
{
    return least(processorsOfQuota(contentOf(folder + "/cpu.max")),
                 processorsOfQuota(contentOf(folder + "/cpu.cfs_quota_us"), contentOf(folder + "/cpu.cfs_period_us")));
}

/// Least quota of a group and of those around it. In a container the path may be that of the host, and not be there:
/// then what is mounted is the group itself.
std::optional<unsigned> ofPath(const std::string& mount, std::string path)
{
    std::optional<unsigned> found = ofFolder(mount);
    while (!path.empty() && path != "/")
    {
        found = least(found, ofFolder(mount + path));
        path.erase(path.rfind('/'));
    }
    return found;
}

bool names(const std::string& controllers, const std::string& wanted)
{
    std::istringstream list(controllers);
    for (std::string name; std::getline(list, name, ',');)
        if (name == wanted)
            return true;
    return false;
}

/// By affinity; none if that cannot be told.
std::optional<unsigned> ofAffinity()
{
#if defined(__linux__)
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0)
        return static_cast<unsigned>(CPU_COUNT(&set));
#endif
    return std::nullopt;
}
}  // namespace

std::optional<unsigned> processorsOfQuota(const std::string& cpuMax)
{
    return fromTimes(cpuMax, "");  // "max" is no number
}

std::optional<unsigned> processorsOfQuota(const std::string& quota, const std::string& period)
{
    return fromTimes(quota, period);
}

std::optional<unsigned> processorsOfGroups(const std::string& selfCgroup, const std::string& root)
{
    std::optional<unsigned> found;
    std::istringstream lines(selfCgroup);
    for (std::string line; std::getline(lines, line);)
    {
        const std::size_t first = line.find(':');
        const std::size_t second = first == line.npos ? line.npos : line.find(':', first + 1);
        if (second == line.npos || line.compare(second + 1, 1, "/") != 0)
            continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string path = line.substr(second + 1);
        if (controllers.empty())  // version 2
            found = least(found, least(ofPath(root, path), ofPath(root + "/unified", path)));
        else if (names(controllers, "cpu"))
        {
            std::string folder = root + '/';
            folder += controllers;
            found = least(found, least(ofPath(root + "/cpu", path), ofPath(folder, path)));
        }
    }
    return found;
}

unsigned availableProcessors()
{
    std::optional<unsigned> found = ofAffinity();
    if (!found)
        found = std::max(std::thread::hardware_concurrency(), 1U);
    return *least(found, processorsOfGroups(contentOf("/proc/self/cgroup"), "/sys/fs/cgroup"));
}
}  // namespace specplan::util
