// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "Options.h"
#include "Problem.h"

namespace specplan::command
{
/// Reads a problem of OMPL.app with its meshes. \throws InputError naming file, line or option; also where specplan was
/// built without FCL.
[[nodiscard]] std::unique_ptr<Problem> readRigidBodyProblem(const std::string& file, const ProblemOptions& options);
}  // namespace specplan::command
