// SPDX-License-Identifier: BSD-3-Clause
// Collisions and distances against plain geometry, on random poses.
#include "specplan/problems/fcl/RigidBodyScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "RigidFixture.h"

namespace specplan::problems
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector3d;
using test::boxMesh;
using test::randomPose;

/// Whether the segment from p to q goes through a triangle.
bool crosses(const Vector3d& p, const Vector3d& q, const std::array<Vector3d, 3>& t)
{
    // Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
    const Vector3d along = q - p;
    const Vector3d edge1 = t[1] - t[0];
    const Vector3d edge2 = t[2] - t[0];
    const Vector3d h = along.cross(edge2);
    const double determinant = edge1.dot(h);
    if (std::abs(determinant) < 1e-14)
        return false;
    const Vector3d s = p - t[0];
    const double u = s.dot(h) / determinant;
    const Vector3d k = s.cross(edge1);
    const double v = along.dot(k) / determinant;
    const double at = edge2.dot(k) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && at >= 0.0 && at <= 1.0;
}

using Triangles = std::vector<std::array<Vector3d, 3>>;

Triangles trianglesOf(const Mesh& mesh, const Isometry3d& pose)
{
    Triangles triangles;
    for (const auto& t : mesh.triangles)
        triangles.push_back({pose * mesh.vertices[t[0]], pose * mesh.vertices[t[1]], pose * mesh.vertices[t[2]]});
    return triangles;
}

/// All pairs of triangles: two of them meet if an edge of one goes through the other.
bool meet(const Triangles& a, const Triangles& b)
{
    for (const auto& s : a)
        for (const auto& t : b)
            for (std::size_t k = 0; k < 3; ++k)
                if (crosses(s[k], s[(k + 1) % 3], t) || crosses(t[k], t[(k + 1) % 3], s))
                    return true;
    return false;
}

double distanceToBox(const Vector3d& point, const Vector3d& half)
{
    return (point.cwiseAbs() - half).cwiseMax(0.0).norm();
}

TEST(RigidBodyScene, MeshesCollideWhereTrianglesMeet)
{
    Mesh robot = boxMesh({-0.5, -0.2, -0.5}, {0.5, 0.2, 0.5});
    addBox(robot, {-0.5, -0.2, 0.5}, {-0.3, 0.2, 1.5});
    const Mesh world = test::roomMesh();
    const RigidBodyScene scene({RigidBody().addMesh(robot)}, RigidBody().addMesh(world));
    std::mt19937 dice(1);
    int hits = 0;
    const Triangles walls = trianglesOf(world, Isometry3d::Identity());
    for (int i = 0; i < 1000; ++i)
    {
        const std::array poses{randomPose(dice, {-2.0, -2.0, -2.0}, {12.0, 12.0, 5.0})};
        const bool hit = scene.collides(poses);
        ASSERT_EQ(hit, meet(trianglesOf(robot, poses[0]), walls)) << "pose " << i;
        hits += hit ? 1 : 0;
    }
    EXPECT_GT(hits, 150);
    EXPECT_LT(hits, 850);
}

TEST(RigidBodyScene, BallAndBoxAreAsFarApartAsTheyAre)
{
    const Vector3d half(1.0, 0.5, 0.25);
    Isometry3d place = Isometry3d::Identity();
    place.translate(Vector3d(3.0, 2.0, 1.0)).rotate(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
    const RigidBodyScene scene({RigidBody().addSphere(0.3)}, RigidBody().addBox(2.0 * half, place));
    std::mt19937 dice(2);
    int hits = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const std::array poses{randomPose(dice, {1.0, 0.0, -1.0}, {5.0, 4.0, 3.0})};
        const double expected = std::max(distanceToBox(place.inverse() * poses[0].translation(), half) - 0.3, 0.0);
        if (expected > 0.0 && expected < 1e-4)
            continue;  // within the rounding of an iterative method
        EXPECT_EQ(scene.collides(poses), expected == 0.0) << "pose " << i << ", distance " << expected;
        EXPECT_NEAR(scene.distance(poses), expected, 1e-3) << "pose " << i;
        hits += expected == 0.0 ? 1 : 0;
    }
    EXPECT_GT(hits, 100);
}

TEST(RigidBodyScene, BallAndMeshAreAsFarApartAsTheyAre)
{
    const Vector3d half(1.0, 0.5, 0.25);
    const RigidBodyScene scene({RigidBody().addSphere(0.2)}, RigidBody().addMesh(boxMesh(-half, half)));
    std::mt19937 dice(3);
    for (int i = 0; i < 2000; ++i)
    {
        const std::array poses{randomPose(dice, {-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0})};
        const double expected = distanceToBox(poses[0].translation(), half) - 0.2;
        if (expected < 1e-4)
            continue;  // inside, a mesh is hollow
        EXPECT_FALSE(scene.collides(poses)) << "pose " << i;
        EXPECT_NEAR(scene.distance(poses), expected, 1e-3) << "pose " << i;
    }
}

TEST(RigidBodyScene, BodiesOfSeveralShapesCollideWithAnyOfThem)
{
    Isometry3d up = Isometry3d::Identity();
    up.translation().z() = 2.0;
    const RigidBody dumbbell = RigidBody().addSphere(0.5).addCylinder(0.1, 2.0).addSphere(0.5, up);
    const RigidBodyScene scene({dumbbell}, RigidBody().addCapsule(0.1, 1.0).addCone(0.2, 0.4, up));
    std::array poses{Isometry3d::Identity()};
    const auto at = [&poses](double x, double z)
    {
        poses[0].translation() = Vector3d(x, 0.0, z);
        return std::span<const Isometry3d>(poses);
    };
    EXPECT_TRUE(scene.collides(at(0.0, 0.0)));
    EXPECT_TRUE(scene.collides(at(0.55, 0.0))) << "ball against capsule";
    EXPECT_FALSE(scene.collides(at(0.75, 0.0)));
    EXPECT_NEAR(scene.distance(at(0.75, 0.0)), std::hypot(0.75 - 0.2, 0.2) - 0.5, 1e-4) << "ball and rim of the cone";
    EXPECT_TRUE(scene.collides(at(0.55, -2.0))) << "upper ball against capsule";
    EXPECT_FALSE(scene.collides(at(3.0, 0.0)));
}

TEST(RigidBodyScene, RobotsCollideWithEachOther)
{
    const RigidBodyScene scene({RigidBody().addSphere(1.0), RigidBody().addSphere(0.5)}, RigidBody());
    std::array poses{Isometry3d::Identity(), Isometry3d::Identity()};
    poses[1].translation().x() = 1.4;
    EXPECT_TRUE(scene.collides(poses));
    EXPECT_EQ(scene.distance(poses), 0.0);
    poses[1].translation().x() = 2.0;
    EXPECT_FALSE(scene.collides(poses));
    EXPECT_NEAR(scene.distance(poses), 0.5, 1e-6);
}

TEST(RigidBodyScene, NothingIsInfinitelyFarAway)
{
    const RigidBodyScene scene({RigidBody().addSphere(1.0)}, RigidBody());
    const std::array poses{Isometry3d::Identity()};
    EXPECT_FALSE(scene.collides(poses));
    EXPECT_EQ(scene.distance(poses), std::numeric_limits<double>::infinity());
}

TEST(RigidBody, RefusesWhatHasNoSize)
{
    EXPECT_EQ(test::complaintOf<std::invalid_argument>([] { RigidBody().addMesh({}); }),
              "a mesh without triangles is no rigid body");
    EXPECT_THROW(RigidBody().addBox({1.0, 0.0, 1.0}), std::invalid_argument);
    EXPECT_THROW(RigidBody().addSphere(-1.0), std::invalid_argument);
    EXPECT_THROW(RigidBody().addCylinder(1.0, std::nan("")), std::invalid_argument);
}
}  // namespace
}  // namespace specplan::problems
