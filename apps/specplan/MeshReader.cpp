// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReader.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include "MeshAnswer.h"
#include "specplan/problems/fcl/MeshFile.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SPECPLAN_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SPECPLAN_SANITIZED 1
#endif
#endif

namespace specplan::command
{
using problems::Mesh;

namespace
{
#ifdef SPECPLAN_SANITIZED
constexpr bool kSanitized = true;  // sanitizers reserve terabytes of addresses
#else
constexpr bool kSanitized = false;
#endif

/// They grow with the file. A good one of 2.7 MB took 0.5 s and 95 MB, so these are far off.
ReaderLimits limitsFor(std::uintmax_t size)
{
    constexpr std::uintmax_t kMegabyte = 1U << 20U;
    const std::uintmax_t megabytes = std::min<std::uintmax_t>(size / kMegabyte, 1U << 16U);
    const std::uint64_t slower = kSanitized ? 20 : 1;
    return {(10 + 10 * megabytes) * slower, (1024 + 400 * megabytes) * kMegabyte};
}

void limit(int resource, std::uint64_t most)
{
    rlimit now = {};
    if (getrlimit(static_cast<decltype(RLIMIT_CPU)>(resource), &now) != 0)
        return;
    now.rlim_cur = std::min<rlim_t>(most, now.rlim_max);  // where time is up SIGXCPU says so, other than the hard limit
    setrlimit(static_cast<decltype(RLIMIT_CPU)>(resource), &now);
}

void writeAll(int pipe, const void* data, std::size_t size)
{
    const char* bytes = static_cast<const char*>(data);
    while (size > 0)
    {
        const ssize_t written = write(pipe, bytes, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            _exit(1);
        bytes += written;
        size -= static_cast<std::size_t>(written);
    }
}

/// The reading process: hands over the mesh, or why there is none.
[[noreturn]] void readAndTell(const std::string& path, const ReaderLimits& limits, int pipe)
{
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, limits.seconds);
    if (!kSanitized)
        limit(RLIMIT_AS, limits.bytes);
    if (const int null = open("/dev/null", O_WRONLY); null >= 0)
        dup2(null, STDERR_FILENO);  // the one line is the parent's
    const SendBytes send = [pipe](const void* data, std::size_t size) { writeAll(pipe, data, size); };
    try
    {
        sendMesh(problems::readMesh(path), send);
    }
    catch (const std::bad_alloc&)
    {
        _exit(1);
    }
    catch (const std::exception& error)
    {
        sendRefusal(error.what(), send);
    }
    _exit(0);
}

/// All that comes through a pipe. \return false if it could not be read.
bool readAll(int pipe, std::string& text)
{
    std::array<char, 1 << 16> piece;
    for (;;)
    {
        const ssize_t size = read(pipe, piece.data(), piece.size());
        if (size > 0)
            text.append(piece.data(), static_cast<std::size_t>(size));
        else if (size == 0 || errno != EINTR)
            return size == 0;
    }
}

[[noreturn]] void failAtSystem(const char* what)
{
    throw std::system_error(errno, std::generic_category(), what);
}
}  // namespace

Mesh readMeshApart(const std::string& path)
{
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    const ReaderLimits limits = limitsFor(unknown ? 0 : size);
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
        failAtSystem("pipe");
    const pid_t child = fork();
    if (child < 0)
        failAtSystem("fork");
    if (child == 0)
    {
        close(ends[0]);
        readAndTell(path, limits, ends[1]);
    }
    close(ends[1]);
    std::string said;
    const bool heard = readAll(ends[0], said);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {
    }
    return meshOf(path, heard ? said : "", status, limits);
}
}  // namespace specplan::command
