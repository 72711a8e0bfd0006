// SPDX-License-Identifier: BSD-3-Clause
#include "Problem.h"

#include <filesystem>
#include <string_view>
#include <utility>

#include "GridMapProblem.h"
#include "Input.h"
#include "RigidBodyProblem.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
namespace
{
/// With a section or a comment, other than a map.
bool beginsLikeConfig(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && (text[first] == '[' || text[first] == '#');
}
}  // namespace

void Problem::requireView() const
{
    throw problems::InputError("--html is for rigid bodies (.cfg); --svg draws maps");
}

void Problem::writeView(std::ostream&, const Run&) const
{
    requireView();
}

std::unique_ptr<Problem> readProblem(const std::string& file, const ProblemOptions& options)
{
    Input input = readInput(file);
    if (std::filesystem::path(file).extension() == ".cfg" || beginsLikeConfig(input.text))
        return readRigidBodyProblem(std::move(input), options);
    return readGridMapProblem(std::move(input), options);
}
}  // namespace specplan::command
