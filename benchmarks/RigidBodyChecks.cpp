// SPDX-License-Identifier: BSD-3-Clause
// What a check of a rigid body costs, for the problems named on the command line: the world as the project has it, one
// tree of bounding volumes or of voxels; as a broad phase over its connected parts or its voxels; of voxels also the
// surface as one tree, which is hollow; and how much two threads gain.
#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <numeric>
#include <thread>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision.h>

#include "specplan/problems/fcl/OctoMap.h"
#include "specplan/problems/fcl/RigidBodyChecker.h"
#include "specplan/problems/fcl/RigidBodySetup.h"

namespace
{
using namespace specplan::problems;
using Clock = std::chrono::steady_clock;
using Check = std::function<bool(const Eigen::Isometry3d&)>;

constexpr std::size_t kStates = 20000;
constexpr int kRepetitions = 3;  // of each check; the shortest counts, so that other programs disturb less

bool isVoxels(const RigidBodySetup& setup)
{
    return isOctoMapFile(setup.problem().world.path);
}

/// The world's parts, or its voxels, in FCL's broad phase.
class BroadPhase
{
public:
    explicit BroadPhase(const RigidBodySetup& setup) : robot_(model(setup.robot()))
    {
        if (isVoxels(setup))
            for (const Eigen::AlignedBox3d& box : occupiedBoxes(*readOctoMap(setup.problem().world.path)))
                objects_.push_back(std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Boxd>(box.sizes()),
                                                                           Eigen::Matrix3d::Identity(), box.center()));
        else
            for (const Mesh& part : connectedParts(setup.world()))
                objects_.push_back(std::make_unique<fcl::CollisionObjectd>(model(part)));
        for (const auto& object : objects_)
            manager_.registerObject(object.get());
        manager_.setup();
    }

    [[nodiscard]] std::size_t parts() const
    {
        return objects_.size();
    }

    [[nodiscard]] bool collides(const Eigen::Isometry3d& pose) const
    {
        fcl::CollisionObjectd robot(robot_, pose);
        bool hit = false;
        manager_.collide(&robot, &hit,
                         [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data)
                         {
                             fcl::CollisionResultd result;
                             bool& found = *static_cast<bool*>(data);
                             found = fcl::collide(a, b, fcl::CollisionRequestd(), result) > 0;
                             return found;
                         });
        return hit;
    }

private:
    static std::shared_ptr<fcl::CollisionGeometryd> model(const Mesh& mesh)
    {
        return std::const_pointer_cast<fcl::CollisionGeometryd>(RigidBody().addMesh(mesh).parts().front().geometry);
    }

    std::shared_ptr<fcl::CollisionGeometryd> robot_;
    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
    fcl::DynamicAABBTreeCollisionManagerd manager_;
};

std::vector<Eigen::Isometry3d> randomPoses(const RigidBodySetup& setup)
{
    const auto simple = setup.makeSetup();
    const auto space = simple->getStateSpace();
    space->setup();
    const auto sampler = space->allocStateSampler();
    ompl::base::ScopedState<> state(space);
    std::vector<Eigen::Isometry3d> poses;
    while (poses.size() < kStates)
    {
        sampler->sampleUniform(state.get());
        poses.push_back(posesOf(*space, state.get()).front());
    }
    return poses;
}

void printRow(const std::string& name, const std::string& layout, const std::vector<Eigen::Isometry3d>& poses,
              const Check& collides)
{
    std::vector<double> micros;
    std::size_t valid = 0;
    for (const Eigen::Isometry3d& pose : poses)
    {
        double best = std::numeric_limits<double>::infinity();
        bool hit = false;
        for (int i = 0; i < kRepetitions; ++i)
        {
            const auto begin = Clock::now();
            hit = collides(pose);
            best = std::min(best, std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
        }
        valid += hit ? 0 : 1;
        micros.push_back(best);
    }
    const double total = std::accumulate(micros.begin(), micros.end(), 0.0);
    std::ranges::sort(micros);
    const auto at = [&micros](double share)
    { return micros[static_cast<std::size_t>(share * static_cast<double>(micros.size() - 1))]; };
    std::cout << "| " << name << " | " << layout << std::fixed << std::setprecision(1) << " | " << at(0.5) << " | "
              << at(0.9) << " | " << at(0.99) << " | " << total / static_cast<double>(micros.size()) << " | "
              << 100.0 * static_cast<double>(valid) / static_cast<double>(poses.size()) << " % |\n";
}

double seconds(std::size_t threads, const std::vector<Eigen::Isometry3d>& poses, const Check& collides)
{
    const auto begin = Clock::now();
    {
        std::vector<std::thread> pool;
        for (std::size_t i = 0; i < threads; ++i)
            pool.emplace_back(
                [&, i]
                {
                    for (std::size_t j = i; j < poses.size(); j += threads)
                        static_cast<void>(collides(poses[j]));
                });
        for (std::thread& thread : pool)
            thread.join();
    }
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void measure(const std::string& file)
{
    const RigidBodySetup setup(readOmplAppProblem(file));
    const std::vector<Eigen::Isometry3d> poses = randomPoses(setup);
    const BroadPhase broadPhase(setup);
    const std::string name = setup.problem().name + ", " + std::to_string(setup.robot().triangles.size()) + " in " +
                             std::to_string(setup.world().triangles.size());
    const Check oneTree = [&setup](const Eigen::Isometry3d& pose) { return setup.scene()->collides({&pose, 1}); };
    printRow(name, isVoxels(setup) ? "octree" : "one tree", poses, oneTree);
    printRow(name, "broad phase, " + std::to_string(broadPhase.parts()) + (isVoxels(setup) ? " voxels" : " parts"),
             poses, [&broadPhase](const Eigen::Isometry3d& pose) { return broadPhase.collides(pose); });
    if (isVoxels(setup))
    {
        const RigidBodyScene surface({RigidBody().addMesh(setup.robot())}, RigidBody().addMesh(setup.world()));
        printRow(name, "surface, one tree", poses,
                 [&surface](const Eigen::Isometry3d& pose) {
                     return surface.collides({&pose, 1});
                 });
    }
    for (const Eigen::Isometry3d& pose : poses)
        if (oneTree(pose) != broadPhase.collides(pose))
            throw std::logic_error(file + ": the two worlds differ");
    std::cerr << name << ": two threads " << std::setprecision(2)
              << seconds(1, poses, oneTree) / seconds(2, poses, oneTree) << " times as fast as one\n";
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc < 2)
    {
        std::cerr << "usage: specplan_bench_rigid_body_checks PROBLEM.cfg...\n";
        return 2;
    }
    try
    {
        std::cout << "| problem, triangles | world | median us | 90 % | 99 % | mean | valid "
                     "|\n|---|---|---|---|---|---|---|\n";
        for (int i = 1; i < argc; ++i)
            measure(argv[i]);
    }
    catch (const std::exception& error)
    {
        std::cerr << "specplan_bench_rigid_body_checks: " << error.what() << '\n';
        return 2;
    }
    return 0;
}
