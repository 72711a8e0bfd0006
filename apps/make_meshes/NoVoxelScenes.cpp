// SPDX-License-Identifier: BSD-3-Clause
// Without OctoMap there are no maps of voxels.
#include "RigidScenes.h"

namespace specplan::make_meshes
{
std::vector<RigidScene> makeVoxelScenes()
{
    return {};
}
}  // namespace specplan::make_meshes
