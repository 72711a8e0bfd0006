// SPDX-License-Identifier: BSD-3-Clause
#include "SpaceCases.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>

namespace specplan::test
{
namespace ob = ompl::base;

namespace
{
using Reals = std::vector<double>;

std::shared_ptr<ob::RealVectorStateSpace> box(unsigned dimension, double high = 1.0)
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(dimension);
    space->setBounds(0.0, high);
    return space;
}

template <typename Plane, typename... Arguments>
ob::StateSpacePtr plane(double high, Arguments... arguments)
{
    auto space = std::make_shared<Plane>(arguments...);
    ob::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(high);
    space->setBounds(bounds);
    return space;
}

/// Distance from a disc in the first two values.
double fromDisc(const Reals& at, double x, double y, double radius)
{
    return std::hypot(at[0] - x, at[1] - y) - radius;
}

/// Measures by the largest difference, not by the Euclidean one, and knows nothing of ours.
class ChebyshevSpace : public ob::RealVectorStateSpace
{
public:
    using ob::RealVectorStateSpace::RealVectorStateSpace;

    double distance(const ob::State* a, const ob::State* b) const override
    {
        double most = 0.0;
        for (unsigned i = 0; i < dimension_; ++i)
            most = std::max(most, std::abs(a->as<StateType>()->values[i] - b->as<StateType>()->values[i]));
        return most;
    }
};

/// Two joints, one within limits and one that turns for ever, in a class that is neither compound nor a RealVector:
/// what MoveIt's joint space looks like to OMPL.
class JointSpace : public ob::StateSpace
{
public:
    class StateType : public ob::State
    {
    public:
        double joints[2];
    };

    JointSpace()
    {
        setName("Joints");
    }

    unsigned getDimension() const override
    {
        return 2;
    }
    double getMaximumExtent() const override
    {
        return 4.0;
    }
    double getMeasure() const override
    {
        return 8.0;
    }
    void enforceBounds(ob::State* state) const override
    {
        double* joints = state->as<StateType>()->joints;
        joints[0] = std::clamp(joints[0], -1.0, 1.0);
        joints[1] = std::remainder(joints[1], 2.0 * std::numbers::pi);
    }
    bool satisfiesBounds(const ob::State* state) const override
    {
        const double* joints = state->as<StateType>()->joints;
        return std::abs(joints[0]) <= 1.0 && std::abs(joints[1]) <= std::numbers::pi;
    }
    void copyState(ob::State* to, const ob::State* from) const override
    {
        std::copy_n(from->as<StateType>()->joints, 2, to->as<StateType>()->joints);
    }
    double distance(const ob::State* a, const ob::State* b) const override
    {
        return std::abs(a->as<StateType>()->joints[0] - b->as<StateType>()->joints[0]) +
               std::abs(turn(a->as<StateType>()->joints[1], b->as<StateType>()->joints[1]));
    }
    bool equalStates(const ob::State* a, const ob::State* b) const override
    {
        return distance(a, b) < 1e-12;
    }
    void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* out) const override
    {
        const double* a = from->as<StateType>()->joints;
        const double* b = to->as<StateType>()->joints;
        out->as<StateType>()->joints[0] = a[0] + t * (b[0] - a[0]);
        out->as<StateType>()->joints[1] = std::remainder(a[1] + t * turn(a[1], b[1]), 2.0 * std::numbers::pi);
    }
    ob::StateSamplerPtr allocDefaultStateSampler() const override
    {
        class Sampler : public ob::StateSampler
        {
        public:
            using ob::StateSampler::StateSampler;
            void sampleUniform(ob::State* state) override
            {
                state->as<StateType>()->joints[0] = rng_.uniformReal(-1.0, 1.0);
                state->as<StateType>()->joints[1] = rng_.uniformReal(-3.0, 3.0);
            }
            void sampleUniformNear(ob::State* state, const ob::State*, double) override
            {
                sampleUniform(state);
            }
            void sampleGaussian(ob::State* state, const ob::State*, double) override
            {
                sampleUniform(state);
            }
        };
        return std::make_shared<Sampler>(this);
    }
    ob::State* allocState() const override
    {
        return new StateType;
    }
    void freeState(ob::State* state) const override
    {
        delete state->as<StateType>();
    }
    double* getValueAddressAtIndex(ob::State* state, unsigned index) const override
    {
        return index < 2 ? state->as<StateType>()->joints + index : nullptr;
    }

private:
    static double turn(double from, double to)
    {
        return std::remainder(to - from, 2.0 * std::numbers::pi);
    }
};

std::vector<SpaceCase> realCases()
{
    const auto disc = [](const Reals& at) { return fromDisc(at, 0.5, 0.45, 0.23); };
    const auto ball = [](const Reals& at) { return std::hypot(fromDisc(at, 0.5, 0.5, 0.0), at[2] - 0.5) - 0.25; };
    std::vector<SpaceCase> cases;
    cases.push_back(
        {"RealVector1", [] { return box(1); }, {0.1}, {{0.83}, {0.97}}, [](const Reals& at) { return 2.0 - at[0]; }});
    cases.push_back({"RealVector2", [] { return box(2); }, {0.11, 0.4}, {{0.83, 0.47}, {0.9, 0.9}}, disc});
    cases.push_back(
        {"RealVector3", [] { return box(3); }, {0.1, 0.4, 0.5}, {{0.83, 0.47, 0.52}, {0.9, 0.9, 0.9}}, ball, 0.16});
    cases.push_back({"RealVector4",
                     [] { return box(4); },
                     {0.1, 0.4, 0.5, 0.1},
                     {{0.83, 0.47, 0.52, 0.12}, {0.9, 0.9, 0.9, 0.1}},
                     ball,
                     0.22});
    cases.push_back({"ZeroExtent",
                     []
                     {
                         auto space = box(3);
                         ob::RealVectorBounds bounds = space->getBounds();
                         bounds.low[2] = bounds.high[2] = 0.7;
                         space->setBounds(bounds);
                         return space;
                     },
                     {0.11, 0.4, 0.7},
                     {{0.83, 0.47, 0.7}, {0.9, 0.9, 0.7}},
                     disc});
    cases.push_back({"OwnMetric",
                     []
                     {
                         auto space = std::make_shared<ChebyshevSpace>(2);
                         space->setBounds(0.0, 1.0);
                         return space;
                     },
                     {0.11, 0.4},
                     {{0.83, 0.47}, {0.9, 0.9}},
                     disc});
    cases.push_back({"OwnClass",
                     [] { return std::make_shared<JointSpace>(); },
                     {-0.8, 2.9},
                     {{0.75, -2.7}, {0.0, 0.5}},
                     [](const Reals& at) { return std::hypot(at[0], std::abs(at[1]) - 3.0) - 0.4; }});
    return cases;
}

std::vector<SpaceCase> angleCases()
{
    const auto disc = [](const Reals& at) { return fromDisc(at, 0.5, 0.45, 0.23); };
    std::vector<SpaceCase> cases;
    cases.push_back({"SO2",
                     [] { return std::make_shared<ob::SO2StateSpace>(); },
                     {2.5},
                     {{-2.4}, {0.1}},
                     [](const Reals& at) { return std::abs(at[0] - 1.5) - 0.3; },
                     0.05});
    cases.push_back({"Torus",
                     []
                     {
                         auto space = std::make_shared<ob::CompoundStateSpace>();
                         space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 1.0);
                         space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 0.3);
                         return space;
                     },
                     {2.5, 0.2},
                     {{-2.4, -2.0}, {0.1, 1.0}},
                     [](const Reals& at) { return fromDisc(at, 3.0, -1.0, 0.7); },
                     0.07});
    cases.push_back({"SE2",
                     [] { return plane<ob::SE2StateSpace>(1.0); },
                     {0.11, 0.4, 3.0},
                     {{0.83, 0.47, -2.5}, {0.9, 0.9, 0.0}},
                     disc,
                     0.11});
    cases.push_back({"SO3",
                     [] { return std::make_shared<ob::SO3StateSpace>(); },
                     {0.0, 0.0, 0.0, 1.0},
                     {{0.6, 0.0, 0.0, -0.8}, {0.0, 1.0, 0.0, 0.0}},
                     [](const Reals& q) { return std::hypot(q[0], q[1] - 0.25, q[2]) - 0.12; },
                     0.25});
    cases.push_back({"SE3",
                     []
                     {
                         auto space = std::make_shared<ob::SE3StateSpace>();
                         ob::RealVectorBounds bounds(3);
                         bounds.setLow(0.0);
                         bounds.setHigh(1.0);
                         space->setBounds(bounds);
                         return space;
                     },
                     {0.1, 0.4, 0.5, 0.0, 0.0, 0.0, 1.0},
                     {{0.83, 0.47, 0.52, 0.0, 0.6, 0.0, 0.8}, {0.9, 0.9, 0.9, 1.0, 0.0, 0.0, 0.0}},
                     [](const Reals& at) { return std::hypot(at[0] - 0.5, at[1] - 0.5, at[2] - 0.5) - 0.25; },
                     0.34,
                     0.03});
    return cases;
}

std::vector<SpaceCase> otherCases()
{
    const auto disc = [](const Reals& at) { return fromDisc(at, 3.0, 2.6, 1.0); };
    const Reals start{0.7, 2.5, 0.3};
    const std::vector<Reals> goals{{5.2, 2.8, -0.4}, {5.0, 5.2, 1.5}};
    std::vector<SpaceCase> cases;
    cases.push_back({"Dubins", [] { return plane<ob::DubinsStateSpace>(6.0, 0.7); }, start, goals, disc, 0.15, 0.05});
    cases.push_back({"DubinsSymmetric", [] { return plane<ob::DubinsStateSpace>(6.0, 0.7, true); }, start, goals, disc,
                     0.15, 0.05});
    cases.push_back(
        {"ReedsShepp", [] { return plane<ob::ReedsSheppStateSpace>(6.0, 0.7); }, start, goals, disc, 0.15, 0.05});
    cases.push_back({"TimeAndPlace",
                     []
                     {
                         auto time = std::make_shared<ob::TimeStateSpace>();
                         time->setBounds(0.0, 1.0);
                         auto space = std::make_shared<ob::CompoundStateSpace>();
                         space->addSubspace(time, 1.0);
                         space->addSubspace(box(1), 1.0);
                         return space;
                     },
                     {0.11, 0.4},
                     {{0.83, 0.47}, {0.9, 0.9}},
                     [](const Reals& at) { return fromDisc(at, 0.5, 0.45, 0.23); }});
    cases.push_back({"FloorsAndPlace",
                     []
                     {
                         auto inner = std::make_shared<ob::CompoundStateSpace>();
                         inner->addSubspace(box(2), 2.0);
                         auto space = std::make_shared<ob::CompoundStateSpace>();
                         space->addSubspace(inner, 0.7);
                         space->addSubspace(std::make_shared<ob::DiscreteStateSpace>(0, 3), 0.25);
                         return space;
                     },
                     {0.11, 0.4},
                     {{0.83, 0.47}, {0.9, 0.9}},
                     [](const Reals& at) { return fromDisc(at, 0.5, 0.45, 0.23); }});
    return cases;
}
}  // namespace

const std::vector<SpaceCase>& spaceCases()
{
    static const std::vector<SpaceCase> cases = []
    {
        std::vector<SpaceCase> all = realCases();
        for (auto& more : {angleCases(), otherCases()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return cases;
}
}  // namespace specplan::test
