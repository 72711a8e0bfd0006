// SPDX-License-Identifier: BSD-3-Clause
#include "Problem.h"

#include <filesystem>

#include "GridMapProblem.h"
#include "RigidBodyProblem.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
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
    if (std::filesystem::path(file).extension() == ".cfg")
        return readRigidBodyProblem(file, options);
    return readGridMapProblem(file, options);
}
}  // namespace specplan::command
