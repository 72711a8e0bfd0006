// SPDX-License-Identifier: BSD-3-Clause
#include "Problem.h"

#include <filesystem>

#include "GridMapProblem.h"
#include "RigidBodyProblem.h"

namespace specplan::command
{
std::unique_ptr<Problem> readProblem(const std::string& file, const ProblemOptions& options)
{
    if (std::filesystem::path(file).extension() == ".cfg")
        return readRigidBodyProblem(file, options);
    return readGridMapProblem(file, options);
}
}  // namespace specplan::command
