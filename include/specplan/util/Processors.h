// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace specplan::util
{
/// How many processors this process may use at once, at least 1: those that its affinity allows (taskset, Slurm, a
/// container's cpuset), and no more than the quotas of its control groups (docker --cpus). What cannot be found out
/// does not count. Reads some files: not for hot loops.
[[nodiscard]] unsigned availableProcessors();

/// Processors that a quota of time stands for, rounded up; none if there is no limit.
/// \param cpuMax content of a cpu.max of control groups version 2: "QUOTA PERIOD" in µs, or "max PERIOD".
[[nodiscard]] std::optional<unsigned> processorsOfQuota(const std::string& cpuMax);

/// The same of version 1. \param quota content of cpu.cfs_quota_us; negative for no limit. \param period of
/// cpu.cfs_period_us.
[[nodiscard]] std::optional<unsigned> processorsOfQuota(const std::string& quota, const std::string& period);

/// The least of all quotas that a process is under: those of its groups and of the groups around them.
/// \param selfCgroup content of /proc/self/cgroup. \param root where control groups are mounted, /sys/fs/cgroup.
[[nodiscard]] std::optional<unsigned> processorsOfGroups(const std::string& selfCgroup, const std::string& root);
}  // namespace specplan::util
