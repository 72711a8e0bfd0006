// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "specplan/problems/fcl/Mesh.h"

namespace specplan::command
{
/// What the process that reads a mesh may take.
struct ReaderLimits
{
    std::uint64_t seconds;
    std::uint64_t bytes;
};

/// Sends some bytes to the other process.
using SendBytes = std::function<void(const void* data, std::size_t size)>;

/// The answer of the process that reads a mesh: the mesh.
void sendMesh(const problems::Mesh& mesh, const SendBytes& send);

/// The answer of the process that reads a mesh: why there is none.
void sendRefusal(std::string_view reason, const SendBytes& send);

/// The mesh of an answer.
/// \param path names the file in messages.
/// \param answer all that the process sent; it may have been damaged with the process.
/// \param status how the process ended, as waitpid() has it.
/// \throws InputError with the reason that was sent, or that the process came to no good end or sent no whole mesh.
[[nodiscard]] problems::Mesh meshOf(const std::string& path, std::string_view answer, int status,
                                    const ReaderLimits& limits);
}  // namespace specplan::command
