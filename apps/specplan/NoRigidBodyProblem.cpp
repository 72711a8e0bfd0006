// SPDX-License-Identifier: BSD-3-Clause
// Built instead of RigidBodyProblem.cpp where FCL or Assimp is missing.
#include "RigidBodyProblem.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
std::unique_ptr<Problem> readRigidBodyProblem(Input input, const ProblemOptions&)
{
    throw problems::InputError(input.name, 0,
                               "rigid-body problems need FCL and Assimp, and this specplan was built without");
}
}  // namespace specplan::command
