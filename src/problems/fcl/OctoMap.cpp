// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/OctoMap.h"

#include <algorithm>
#include <bit>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <octomap/octomap.h>

#include <fcl/geometry/octree/octree.h>

#include "VoxelSurface.h"
#include "specplan/problems/fcl/RigidBody.h"

namespace specplan::problems
{
namespace
{
/// Occupied or not, and nothing in between; the inner nodes fit their children, which they need not after lazy updates.
std::shared_ptr<const octomap::OcTree> settled(const octomap::OcTree& map)
{
    auto copy = std::make_shared<octomap::OcTree>(map);
    for (auto leaf = copy->begin_leafs(), end = copy->end_leafs(); leaf != end; ++leaf)
        leaf->setLogOdds(map.isNodeOccupied(*leaf) ? 1.0F : -1.0F);
    // FCL takes nodes below even odds for free whatever the map's threshold is.
    copy->setOccupancyThres(0.5);
    copy->updateInnerOccupancy();
    copy->prune();
    return copy;
}

/// Finds the sides of occupied voxels that face free or unknown space and joins them to rectangles.
class SurfaceMaker
{
public:
    explicit SurfaceMaker(const octomap::OcTree& map) : map_(map)
    {
    }

    Mesh make()
    {
        for (auto leaf = map_.begin_leafs(), end = map_.end_leafs(); leaf != end; ++leaf)
            if (map_.isNodeOccupied(*leaf))
                addSides(leaf.getIndexKey(), 1 << (map_.getTreeDepth() - leaf.getDepth()));
        for (auto& [plane, cells] : planes_)
            joinCells(plane, cells);
        return std::move(mesh_);
    }

private:
    using Plane = std::tuple<unsigned, int, bool>;   // axis, key of the voxels above it, whether the sides face up
    using Cells = std::vector<std::pair<int, int>>;  // keys along the two axes after it

    /// Lower and upper keys of cells, and those of their rows.
    struct Rectangle
    {
        int low;
        int high;
        int from;
        int to;
    };

    using Keys = std::array<int, 3>;

    void addSides(const octomap::OcTreeKey& low, int size)
    {
        for (unsigned axis = 0; axis < 3; ++axis)
            for (const bool up : {false, true})
            {
                Keys beyond{low[0], low[1], low[2]};
                beyond[axis] += up ? size : -1;
                addSide({axis, beyond[axis] + (up ? 0 : 1), up}, beyond, size);
            }
    }

    /// \param beyond the voxel of lowest keys on the other side. \param size voxels along each edge, a power of two.
    void addSide(const Plane& plane, Keys beyond, int size)
    {
        constexpr int kJoined = 64;  // larger ones are rectangles of their own; a side may have 2^30 cells
        const unsigned axis = std::get<0>(plane);
        int& row = beyond[(axis + 1) % 3];
        int& place = beyond[(axis + 2) % 3];
        const auto [isUniform, isOpen] = look(beyond, size);
        if (isUniform && !isOpen)
            return;
        if (isUniform && size > kJoined)
            addRectangle(plane, {place, place + size, row, row + size});
        else if (isUniform)
            for (int i = 0; i < size; ++i)
                for (int j = 0; j < size; ++j)
                    planes_[plane].emplace_back(row + i, place + j);
        else
        {
            const int half = size / 2;
            const Keys low = beyond;
            for (const int i : {0, half})
                for (const int j : {0, half})
                {
                    beyond = low;
                    row += i;
                    place += j;
                    addSide(plane, beyond, half);
                }
        }
    }

    struct Look
    {
        bool isUniform;  ///< nothing is known in more detail
        bool isOpen;     ///< free or unknown
    };

    /// What is in the cube of such a size around a voxel.
    [[nodiscard]] Look look(const Keys& keys, int size) const
    {
        octomap::OcTreeKey key;
        for (unsigned i = 0; i < 3; ++i)
        {
            if (keys[i] < 0 || keys[i] >= 1 << map_.getTreeDepth())
                return {true, true};
            key[i] = static_cast<octomap::key_type>(keys[i]);
        }
        const auto depth = map_.getTreeDepth() - static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(size)));
        const octomap::OcTreeNode* node = map_.search(key, depth);
        if (node == nullptr)
            return {true, true};
        return {!map_.nodeHasChildren(node), !map_.isNodeOccupied(node)};
    }

    /// Cells in a row are joined, then rows of the same extent that follow each other.
    void joinCells(const Plane& plane, Cells& cells)
    {
        std::sort(cells.begin(), cells.end());
        std::map<std::pair<int, int>, Rectangle> open;
        for (std::size_t i = 0; i < cells.size();)
        {
            const auto [row, low] = cells[i];
            int high = low;
            for (; i < cells.size() && cells[i] == std::pair(row, high); ++i)
                ++high;
            const auto [above, isNew] = open.try_emplace({low, high}, Rectangle{low, high, row, row});
            if (!isNew && above->second.to != row)
            {
                addRectangle(plane, above->second);
                above->second.from = row;
            }
            above->second.to = row + 1;
        }
        for (const auto& [extent, rectangle] : open)
            addRectangle(plane, rectangle);
    }

    void addRectangle(const Plane& plane, const Rectangle& rectangle)
    {
        const auto& [axis, layer, up] = plane;
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (const auto& [row, place] :
             {std::pair(rectangle.from, rectangle.low), std::pair(rectangle.to, rectangle.low),
              std::pair(rectangle.to, rectangle.high), std::pair(rectangle.from, rectangle.high)})
        {
            Eigen::Vector3d corner;
            corner[axis] = lowerSide(layer);
            corner[(axis + 1) % 3] = lowerSide(row);
            corner[(axis + 2) % 3] = lowerSide(place);
            mesh_.vertices.push_back(corner);
        }
        for (const std::uint32_t i : {1U, 2U})
            mesh_.triangles.push_back({first, first + (up ? i : i + 1), first + (up ? i + 1 : i)});
    }

    [[nodiscard]] double lowerSide(int key) const
    {
        return (key - (1 << (map_.getTreeDepth() - 1))) * map_.getResolution();
    }

    const octomap::OcTree& map_;
    std::map<Plane, Cells> planes_;
    Mesh mesh_;
};
}  // namespace

bool hasOctoMap() noexcept
{
    return true;
}

Eigen::AlignedBox3d boundsOf(const octomap::OcTree& map)
{
    Eigen::Vector3d low;
    Eigen::Vector3d high;
    map.getMetricMin(low.x(), low.y(), low.z());
    map.getMetricMax(high.x(), high.y(), high.z());
    return {low, high};
}

std::vector<Eigen::AlignedBox3d> occupiedBoxes(const octomap::OcTree& map)
{
    std::vector<Eigen::AlignedBox3d> boxes;
    for (auto leaf = map.begin_leafs(), end = map.end_leafs(); leaf != end; ++leaf)
        if (map.isNodeOccupied(*leaf))
        {
            const Eigen::Vector3d centre(leaf.getX(), leaf.getY(), leaf.getZ());
            const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * leaf.getSize());
            boxes.emplace_back(centre - half, centre + half);
        }
    return boxes;
}

Mesh surfaceOf(const octomap::OcTree& map)
{
    return SurfaceMaker(map).make();
}

RigidBody& RigidBody::addOctoMap(const octomap::OcTree& map, const Eigen::Isometry3d& pose)
{
    const std::shared_ptr<const octomap::OcTree> voxels = settled(map);
    Eigen::AlignedBox3d box;
    for (const Eigen::AlignedBox3d& voxel : occupiedBoxes(*voxels))
        box.extend(voxel);
    if (box.isEmpty())
        throw std::invalid_argument("a map without occupied voxels is no rigid body");
    add(std::make_shared<fcl::OcTreed>(voxels), pose);
    // FCL's box is around all that the map could hold, some kilometres.
    Part& part = parts_.back();
    part.centre = pose * box.center();
    part.radius = 0.5 * box.diagonal().norm();
    part.surface = std::make_shared<const VoxelSurface>(
        [voxels] { return RigidBody().addMesh(surfaceOf(*voxels)).parts().front().geometry; });
    return *this;
}
}  // namespace specplan::problems
