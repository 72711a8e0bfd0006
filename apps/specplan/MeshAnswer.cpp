// SPDX-License-Identifier: BSD-3-Clause
#include "MeshAnswer.h"

#include <sys/wait.h>

#include <csignal>
#include <cstring>
#include <type_traits>
#include <vector>

#include "specplan/problems/InputError.h"

namespace specplan::command
{
using problems::concat;
using problems::InputError;
using problems::Mesh;

namespace
{
/// What the reading process says first.
constexpr char kMesh = 'm';
constexpr char kRefusal = 'r';  // followed by the reason

template <typename T>
void sendRow(const std::vector<T>& row, const SendBytes& send)
{
    static_assert(std::is_trivially_copyable_v<T> || std::is_same_v<T, Eigen::Vector3d>);
    const std::uint64_t count = row.size();
    send(&count, sizeof count);
    send(row.data(), count * sizeof(T));
}

/// Takes a row that sendRow() sent off the front. \return false if it is not whole.
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
    if (count > 0)
        std::memcpy(static_cast<void*>(row.data()), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
    return true;
}

[[noreturn]] void fail(const std::string& path, const std::string& reason)
{
    throw InputError(path, 0, "expected a mesh (COLLADA, STL, OBJ), but its reader (Assimp) " + reason);
}

void requireGoodEnd(const std::string& path, std::string_view answer, int status, const ReaderLimits& limits)
{
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU)
        fail(path, concat("was still at it after ", limits.seconds, " s; is it damaged?"));
    if (signal != 0)
        fail(path, concat("crashed (signal ", signal, "); is it damaged?"));
    if (answer.empty() || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        fail(path, concat("asked for more than ", limits.bytes >> 20U, " MiB; is it damaged?"));
}
}  // namespace

void sendMesh(const Mesh& mesh, const SendBytes& send)
{
    send(&kMesh, 1);
    sendRow(mesh.vertices, send);
    sendRow(mesh.triangles, send);
}

void sendRefusal(std::string_view reason, const SendBytes& send)
{
    send(&kRefusal, 1);
    send(reason.data(), reason.size());
}

Mesh meshOf(const std::string& path, std::string_view answer, int status, const ReaderLimits& limits)
{
    requireGoodEnd(path, answer, status, limits);
    const char first = answer.front();
    answer.remove_prefix(1);
    if (first == kRefusal && !answer.empty())
        throw InputError(std::string(answer));
    Mesh mesh;
    if (first != kMesh || !takeRow(answer, mesh.vertices) || !takeRow(answer, mesh.triangles) || !answer.empty())
        fail(path, "handed over only part of it");
    requireSound(mesh, path);
    return mesh;
}
}  // namespace specplan::command
