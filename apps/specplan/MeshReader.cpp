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
#include <cstring>
#include <filesystem>
#include <system_error>
#include <type_traits>
#include <vector>

#include "specplan/problems/InputError.h"
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
using problems::InputError;
using problems::Mesh;

namespace
{
#ifdef SPECPLAN_SANITIZED
constexpr bool kSanitized = true;  // sanitizers reserve terabytes of addresses
#else
constexpr bool kSanitized = false;
#endif

/// What the reading process says first.
enum class Outcome : char
{
    Mesh = 'm',
    Refused = 'r'  ///< followed by the reason
};

/// Limits that grow with the file. A good one of 2.7 MB took 0.5 s and 95 MB, so these are far off.
struct Limits
{
    rlim_t seconds;
    rlim_t bytes;
};

Limits limitsFor(std::uintmax_t size)
{
    constexpr std::uintmax_t kMegabyte = 1U << 20U;
    const std::uintmax_t megabytes = std::min<std::uintmax_t>(size / kMegabyte, 1U << 16U);
    const rlim_t slower = kSanitized ? 20 : 1;
    return {static_cast<rlim_t>(10 + 10 * megabytes) * slower,
            static_cast<rlim_t>((1024 + 400 * megabytes) * kMegabyte)};
}

void limit(int resource, rlim_t most)
{
    rlimit now = {};
    if (getrlimit(static_cast<decltype(RLIMIT_CPU)>(resource), &now) != 0)
        return;
    now.rlim_cur = std::min(most, now.rlim_max);  // where time is up SIGXCPU says so, other than the hard limit
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

template <typename T>
void writeRow(int pipe, const std::vector<T>& row)
{
    static_assert(std::is_trivially_copyable_v<T> || std::is_same_v<T, Eigen::Vector3d>);
    const std::uint64_t count = row.size();
    writeAll(pipe, &count, sizeof count);
    writeAll(pipe, row.data(), count * sizeof(T));
}

/// The reading process: hands over the mesh, or why there is none.
[[noreturn]] void readAndTell(const std::string& path, const Limits& limits, int pipe)
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
    char outcome = static_cast<char>(Outcome::Mesh);
    try
    {
        const Mesh mesh = problems::readMesh(path);
        writeAll(pipe, &outcome, 1);
        writeRow(pipe, mesh.vertices);
        writeRow(pipe, mesh.triangles);
    }
    catch (const std::bad_alloc&)
    {
        _exit(1);
    }
    catch (const std::exception& error)
    {
        outcome = static_cast<char>(Outcome::Refused);
        writeAll(pipe, &outcome, 1);
        writeAll(pipe, error.what(), std::strlen(error.what()));
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

/// Takes a row that writeRow() wrote off the front. \return false if it is not whole.
template <typename T>
bool takeRow(std::string_view& bytes, std::vector<T>& row)
{
    std::uint64_t count = 0;
    if (bytes.size() < sizeof count)
        return false;
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes.remove_prefix(sizeof count);
    if (count > bytes.size() / sizeof(T))
        return false;
    row.resize(count);
    std::memcpy(static_cast<void*>(row.data()), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
    return true;
}

bool takeMesh(std::string_view bytes, Mesh& mesh)
{
    return takeRow(bytes, mesh.vertices) && takeRow(bytes, mesh.triangles) && bytes.empty();
}

[[noreturn]] void fail(const std::string& path, const std::string& reason)
{
    throw InputError(path, 0, "expected a mesh (COLLADA, STL, OBJ), but " + reason);
}

[[noreturn]] void failAtSystem(const char* what)
{
    throw std::system_error(errno, std::generic_category(), what);
}

/// \param status of the reading process, as waitpid() has it.
[[noreturn]] void failOf(const std::string& path, int status, const Limits& limits)
{
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU)
        fail(path,
             problems::concat("its reader (Assimp) was still at it after ", limits.seconds, " s; is it damaged?"));
    if (signal != 0)
        fail(path, problems::concat("its reader (Assimp) crashed (signal ", signal, "); is it damaged?"));
    fail(path,
         problems::concat("its reader (Assimp) asked for more than ", limits.bytes >> 20U, " MiB; is it damaged?"));
}
}  // namespace

Mesh readMeshApart(const std::string& path)
{
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    const Limits limits = limitsFor(unknown ? 0 : size);
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
    if (!heard || said.empty() || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        failOf(path, status, limits);
    if (said.front() == static_cast<char>(Outcome::Refused))
        throw InputError(said.substr(1));
    Mesh mesh;
    if (!takeMesh(std::string_view(said).substr(1), mesh))
        fail(path, "its reader (Assimp) handed over only part of it");
    return mesh;
}
}  // namespace specplan::command
