// SPDX-License-Identifier: BSD-3-Clause
#include <octomap/octomap.h>

#include "RigidScenes.h"

namespace specplan::make_meshes
{
using problems::Mesh;

namespace
{
/// A voxel by its place in a grid whose voxel 0 has a corner in the origin.
using Cell = std::array<int, 3>;

/// A map of voxels of 0.1.
class VoxelMap
{
public:
    /// Sets all voxels from `low` to `high`, the latter not included.
    void set(const Cell& low, const Cell& high, bool occupied)
    {
        constexpr int kOrigin = 32768;  // OctoMap's key of the voxel whose lower corner is the origin
        for (int x = low[0]; x < high[0]; ++x)
            for (int y = low[1]; y < high[1]; ++y)
                for (int z = low[2]; z < high[2]; ++z)
                {
                    const auto key = [](int i) { return static_cast<octomap::key_type>(i + kOrigin); };
                    map_->setNodeValue(octomap::OcTreeKey(key(x), key(y), key(z)), occupied ? 2.0F : -2.0F, true);
                }
    }

    std::shared_ptr<const octomap::OcTree> take()
    {
        map_->toMaxLikelihood();
        map_->updateInnerOccupancy();
        map_->prune();
        return map_;
    }

private:
    std::shared_ptr<octomap::OcTree> map_ = std::make_shared<octomap::OcTree>(0.1);
};
}  // namespace

std::vector<RigidScene> makeVoxelScenes()
{
    VoxelMap map;
    // Two rooms, known free inside, with floor and walls one voxel thick, as a sensor sees them.
    map.set({0, 0, 0}, {80, 50, 20}, false);
    map.set({-1, -1, -1}, {81, 51, 0}, true);
    map.set({-1, -1, 0}, {0, 51, 20}, true);
    map.set({80, -1, 0}, {81, 51, 20}, true);
    map.set({0, -1, 0}, {80, 0, 20}, true);
    map.set({0, 50, 0}, {80, 51, 20}, true);
    // A wall with a doorway 1 wide, a table on four legs, a shelf.
    map.set({38, 0, 0}, {40, 30, 20}, true);
    map.set({38, 40, 0}, {40, 50, 20}, true);
    map.set({50, 22, 7}, {66, 32, 8}, true);
    for (const int x : {50, 65})
        for (const int y : {22, 31})
            map.set({x, y, 0}, {x + 1, y + 1, 7}, true);
    map.set({10, 0, 0}, {30, 4, 18}, true);

    Mesh robot;
    problems::addBox(robot, {-0.5, -0.3, 0.1}, {0.5, 0.3, 0.5});
    problems::addBox(robot, {-0.5, -0.05, 0.5}, {-0.4, 0.05, 1.5});
    return {{"scan",
             configText("scan", "scan-world.bt",
                        "A trolley with a pole through a doorway and past a table, in a map of voxels (metres).",
                        planarPoseText("start", 1.0, 1.0, 0.0), planarPoseText("goal", 7.0, 2.7, 0.0),
                        {{0.0, 8.0}, {0.0, 5.0}}),
             robot,
             {},
             map.take()}};
}
}  // namespace specplan::make_meshes
