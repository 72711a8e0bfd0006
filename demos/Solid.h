// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/utility.h>
#include <fcl/narrowphase/collision.h>
#include <Eigen/Geometry>

#include "Drawing.h"

namespace demo
{
/// A convex body of FCL in its place. Constant once made, so any number of threads may share it: fcl::CollisionObject
/// would write to its shape.
template <typename Shape>
struct Solid
{
    Shape shape;
    Eigen::Isometry3d place;
    fcl::AABBd bounds;

    Solid(const Shape& itsShape, const Eigen::Isometry3d& itsPlace) : shape(itsShape), place(itsPlace)
    {
        fcl::computeBV(shape, place, bounds);
    }
};

using Box = Solid<fcl::Boxd>;
using Capsule = Solid<fcl::Capsuled>;

/// A box between two corners, its edges parallel to the axes.
inline Box boxBetween(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
    return {fcl::Boxd(high - low), Eigen::Isometry3d(Eigen::Translation3d((low + high) / 2.0))};
}

template <typename A, typename B>
bool collide(const Solid<A>& a, const Solid<B>& b)
{
    if (!a.bounds.overlap(b.bounds))
        return false;
    fcl::CollisionResultd result;
    return fcl::collide(&a.shape, a.place, &b.shape, b.place, fcl::CollisionRequestd(), result) > 0;
}

/// The outline of a box seen along an axis. \param across, up the axes that show in the picture, 0 to 2.
inline Points outline(const Box& box, int across, int up)
{
    Points corners;
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
            for (const double z : {-0.5, 0.5})
            {
                const Eigen::Vector3d corner = box.place * box.shape.side.cwiseProduct(Eigen::Vector3d(x, y, z));
                corners.push_back({corner[across], corner[up]});
            }
    return convexHull(corners);
}
}  // namespace demo
