// SPDX-License-Identifier: BSD-3-Clause
// What is left where OctoMap was not found, or FCL was built without it.
#include <stdexcept>

#include "specplan/problems/InputError.h"
#include "specplan/problems/fcl/OctoMap.h"
#include "specplan/problems/fcl/RigidBody.h"

namespace specplan::problems
{
namespace
{
[[noreturn]] void fail()
{
    throw std::logic_error("specplan was built without OctoMap");
}
}  // namespace

bool hasOctoMap() noexcept
{
    return false;
}

std::shared_ptr<const octomap::OcTree> readOctoMap(const std::string& path)
{
    throw InputError(path, 0,
                     "expected a mesh: specplan was built without OctoMap, which this file needs (FCL built with it, "
                     "and liboctomap-dev)");
}

void writeOctoMap(const std::string& /*path*/, const octomap::OcTree& /*map*/)
{
    fail();
}

Eigen::AlignedBox3d boundsOf(const octomap::OcTree& /*map*/)
{
    fail();
}

std::vector<Eigen::AlignedBox3d> occupiedBoxes(const octomap::OcTree& /*map*/)
{
    fail();
}

Mesh surfaceOf(const octomap::OcTree& /*map*/)
{
    fail();
}

RigidBody& RigidBody::addOctoMap(const octomap::OcTree& /*map*/, const Eigen::Isometry3d& /*pose*/)
{
    fail();
}
}  // namespace specplan::problems
