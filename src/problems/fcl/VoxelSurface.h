// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include <fcl/geometry/collision_geometry.h>

namespace specplan::problems
{
/// The surface of a map's occupied voxels as a mesh, for distances. It is made when it is first asked for: a map of
/// many voxels takes seconds, and who asks for collisions only never needs it.
///
/// Threads: any number may ask at once; one makes it, the others wait.
class VoxelSurface
{
public:
    using Geometry = std::shared_ptr<const fcl::CollisionGeometryd>;

    explicit VoxelSurface(std::function<Geometry()> make) : make_(std::move(make))
    {
    }

    [[nodiscard]] const fcl::CollisionGeometryd& geometry() const
    {
        std::call_once(made_, [this] { geometry_ = make_(); });
        return *geometry_;
    }

private:
    std::function<Geometry()> make_;
    mutable std::once_flag made_;
    mutable Geometry geometry_;
};
}  // namespace specplan::problems
