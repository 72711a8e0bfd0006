// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/Decomposition.h"

#include <typeindex>
#include <typeinfo>

#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>
#include <ompl/base/spaces/WrapperStateSpace.h>
#include <ompl/util/Exception.h>

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
/// Whether OMPL itself says how the space measures distances, so that nothing is overridden.
bool isOmpls(const ob::StateSpace& space)
{
    const std::type_index type(typeid(space));
    return type == typeid(ob::RealVectorStateSpace) || type == typeid(ob::SO2StateSpace) ||
           type == typeid(ob::SO3StateSpace) || type == typeid(ob::TimeStateSpace) ||
           type == typeid(ob::DiscreteStateSpace) || type == typeid(ob::CompoundStateSpace) ||
           type == typeid(ob::SE2StateSpace) || type == typeid(ob::SE3StateSpace) ||
           type == typeid(ob::DubinsStateSpace) || type == typeid(ob::ReedsSheppStateSpace);
}

bool isOfPoses(const ob::StateSpace& space)
{
    return dynamic_cast<const ob::SE2StateSpace*>(&space) != nullptr ||
           dynamic_cast<const ob::SE3StateSpace*>(&space) != nullptr;
}

void takeApart(const ob::StateSpacePtr& space, const SpaceHooks& hooks, const std::vector<unsigned>& path,
               double weight, bool place, Decomposition& out)
{
    if (const LatticeAxes* described = hooks.axesOf(*space, path.empty()))
    {
        out.sumsDistances = false;
        out.isOmpls = false;
        out.parts.push_back({space, path, weight, false, described});
        return;
    }
    if (dynamic_cast<const ob::WrapperStateSpace*>(space.get()) != nullptr)
        throw ompl::Exception(
            "the state space '" + space->getName() +
            "' is constrained to a manifold, over which there is no lattice: plan in coordinates of "
            "the manifold (angles on a sphere, joints of a closed chain), or with a sampling planner");
    out.sumsDistances = out.sumsDistances && isOmpls(*space);
    out.isOmpls = out.isOmpls && isOmpls(*space);
    const auto* compound = dynamic_cast<const ob::CompoundStateSpace*>(space.get());
    if (compound == nullptr || isCar(*space))
    {
        out.parts.push_back({space, path, weight, place});
        return;
    }
    for (unsigned i = 0; i < compound->getSubspaceCount(); ++i)
    {
        std::vector<unsigned> longer = path;
        longer.push_back(i);
        // The first subspace of SE2 and SE3 is the place.
        takeApart(compound->getSubspace(i), hooks, longer, weight * compound->getSubspaceWeight(i),
                  i == 0 && isOfPoses(*space), out);
    }
}
}  // namespace

bool isCar(const ob::StateSpace& space)
{
    return dynamic_cast<const ob::DubinsStateSpace*>(&space) != nullptr ||
           dynamic_cast<const ob::ReedsSheppStateSpace*>(&space) != nullptr;
}

ob::State* Part::of(ob::State* whole) const
{
    for (const unsigned i : path)
        whole = whole->as<ob::CompoundState>()->components[i];
    return whole;
}

const ob::State* Part::of(const ob::State* whole) const
{
    for (const unsigned i : path)
        whole = whole->as<ob::CompoundState>()->components[i];
    return whole;
}

Decomposition decompose(const ob::StateSpacePtr& space, const SpaceHooks& hooks)
{
    Decomposition decomposition;
    takeApart(space, hooks, {}, 1.0, false, decomposition);
    return decomposition;
}
}  // namespace specplan::planner
