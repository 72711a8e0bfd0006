// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/RigidBody.h"

#include <stdexcept>
#include <string>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

namespace specplan::problems
{
namespace
{
void requirePositive(double value, const char* what)
{
    if (!(value > 0.0))
        throw std::invalid_argument(std::string(what) + " must be greater than 0, not " + std::to_string(value));
}
}  // namespace

RigidBody& RigidBody::add(std::shared_ptr<fcl::CollisionGeometryd> geometry, const Eigen::Isometry3d& pose)
{
    geometry->computeLocalAABB();
    const Eigen::Vector3d centre = pose * geometry->aabb_center;
    const double radius = geometry->aabb_radius;
    parts_.push_back({std::move(geometry), pose, centre, radius});
    return *this;
}

RigidBody& RigidBody::addMesh(const Mesh& mesh)
{
    if (mesh.triangles.empty())
        throw std::invalid_argument("a mesh without triangles is no rigid body");
    std::vector<fcl::Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& corners : mesh.triangles)
        triangles.emplace_back(corners[0], corners[1], corners[2]);
    auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
    model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
    model->addSubModel(mesh.vertices, triangles);
    model->endModel();
    return add(std::move(model), Eigen::Isometry3d::Identity());
}

RigidBody& RigidBody::addBox(const Eigen::Vector3d& size, const Eigen::Isometry3d& pose)
{
    requirePositive(size.minCoeff(), "the size of a box");
    return add(std::make_shared<fcl::Boxd>(size), pose);
}

RigidBody& RigidBody::addSphere(double radius, const Eigen::Isometry3d& pose)
{
    requirePositive(radius, "the radius of a sphere");
    return add(std::make_shared<fcl::Sphered>(radius), pose);
}

RigidBody& RigidBody::addCylinder(double radius, double length, const Eigen::Isometry3d& pose)
{
    requirePositive(radius, "the radius of a cylinder");
    requirePositive(length, "the length of a cylinder");
    return add(std::make_shared<fcl::Cylinderd>(radius, length), pose);
}

RigidBody& RigidBody::addCapsule(double radius, double length, const Eigen::Isometry3d& pose)
{
    requirePositive(radius, "the radius of a capsule");
    requirePositive(length, "the length of a capsule");
    return add(std::make_shared<fcl::Capsuled>(radius, length), pose);
}

RigidBody& RigidBody::addCone(double radius, double length, const Eigen::Isometry3d& pose)
{
    requirePositive(radius, "the radius of a cone");
    requirePositive(length, "the length of a cone");
    return add(std::make_shared<fcl::Coned>(radius, length), pose);
}
}  // namespace specplan::problems
