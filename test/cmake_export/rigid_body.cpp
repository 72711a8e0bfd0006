// SPDX-License-Identifier: BSD-3-Clause
// A user's program: is a ball clear of a box? And is a map without a file refused, with or without OctoMap?
#include <array>

#include <specplan/problems/InputError.h>
#include <specplan/problems/fcl/OctoMap.h>
#include <specplan/problems/fcl/RigidBodyScene.h>

namespace
{
bool refusesMissingMaps()
{
    try
    {
        return specplan::problems::readOctoMap("none.bt") == nullptr;
    }
    catch (const specplan::problems::InputError&)
    {
        return true;
    }
}
}  // namespace

int main()
{
    const specplan::problems::RigidBodyScene scene({specplan::problems::RigidBody().addSphere(0.5)},
                                                   specplan::problems::RigidBody().addBox({1.0, 1.0, 1.0}));
    std::array poses{Eigen::Isometry3d::Identity()};
    const bool inside = scene.collides(poses);
    poses[0].translation().x() = 1.1;
    return inside && !scene.collides(poses) && refusesMissingMaps() ? 0 : 1;
}
