// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "Input.h"
#include "Options.h"
#include "Problem.h"

namespace specplan::command
{
/// Reads a problem of OMPL.app with its meshes. \throws InputError naming file, line or option; also where specplan was
/// built without FCL.
[[nodiscard]] std::unique_ptr<Problem> readRigidBodyProblem(Input input, const ProblemOptions& options);
}  // namespace specplan::command
