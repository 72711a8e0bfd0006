// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include <ompl/base/StateSpace.h>

#include "GroupSpace.h"

namespace specplan::test
{
/// A look-alike of MoveIt's pose parameterization over an arm of three links in the plane: next to the joint values a
/// state has the pose of the tip, from which interpolate() computes the joint values again. copyFromReals() does not
/// reach the pose.
class PoseSpace : public GroupSpace
{
public:
    enum PoseFlags : unsigned
    {
        PoseComputed = 512
    };

    struct PoseState : GroupSpace::StateType
    {
        std::array<double, 3> pose{1e3, 1e3, 1e3};  ///< x, y, direction

        /// As MoveIt's states have it; joint values are always there here.
        void setJointsComputed(bool)
        {
        }

        void setPoseComputed(bool value)
        {
            flags = value ? flags | PoseComputed : flags & ~static_cast<unsigned>(PoseComputed);
        }
    };

    /// \param marksCopies whether the copy of a state without a pose is marked as invalid.
    explicit PoseSpace(bool marksCopies)
        : GroupSpace({{Joint::Kind::Revolute, 2.0}, {Joint::Kind::Revolute, 2.0}, {Joint::Kind::Revolute, 2.0}}),
          marksCopies_(marksCopies)
    {
        setName("arm_PoseModel");
    }

    ob::State* allocState() const override
    {
        auto* state = new PoseState;
        state->values = new double[count()]();
        return state;
    }

    void freeState(ob::State* state) const override
    {
        delete[] valuesOf(state);
        delete state->as<PoseState>();
    }

    void copyState(ob::State* to, const ob::State* from) const override
    {
        GroupSpace::copyState(to, from);
        to->as<PoseState>()->pose = from->as<PoseState>()->pose;
        if ((to->as<PoseState>()->flags & PoseComputed) == 0 && marksCopies_)
            markInvalid(to);
    }

    double distance(const ob::State* a, const ob::State* b) const override
    {
        double squared = 0.0;
        for (std::size_t i = 0; i < count(); ++i)
            squared += (valuesOf(a)[i] - valuesOf(b)[i]) * (valuesOf(a)[i] - valuesOf(b)[i]);
        return std::sqrt(squared);
    }

    double getMaximumExtent() const override
    {
        return 7.0;
    }

    void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override
    {
        const std::array<double, 3> start = from->as<PoseState>()->pose;
        const std::array<double, 3> end = to->as<PoseState>()->pose;
        GroupSpace::interpolate(from, to, t, state);
        auto* made = state->as<PoseState>();
        for (std::size_t i = 0; i < 3; ++i)
            made->pose[i] = start[i] + t * (end[i] - start[i]);
        made->flags |= PoseComputed;
        if (!computeJoints(state))
            markInvalid(state);
    }

    /// Computes the pose from the joint values, whatever it was.
    void computePose(ob::State* state) const
    {
        auto* made = state->as<PoseState>();
        const double* q = made->values;
        const double a = q[0];
        const double b = a + q[1];
        const double c = b + q[2];
        made->pose = {std::cos(a) + std::cos(b) + std::cos(c), std::sin(a) + std::sin(b) + std::sin(c), c};
        made->flags |= PoseComputed;
    }

private:
    static void markInvalid(ob::State* state)
    {
        state->as<PoseState>()->flags |= ValidityKnown;
        state->as<PoseState>()->flags &= ~static_cast<unsigned>(ValidityTrue);
    }

    /// Joint values for the pose, the elbow as it was; false if the arm does not reach that far.
    [[nodiscard]] bool computeJoints(ob::State* state) const
    {
        const std::array<double, 3>& pose = state->as<PoseState>()->pose;
        double* q = valuesOf(state);
        const double x = pose[0] - std::cos(pose[2]);
        const double y = pose[1] - std::sin(pose[2]);
        const double cosine = (x * x + y * y - 2.0) / 2.0;
        if (!(std::abs(cosine) <= 1.0))
            return false;
        const double elbow = q[1] < 0.0 ? -std::acos(cosine) : std::acos(cosine);
        q[0] = std::atan2(y, x) - std::atan2(std::sin(elbow), 1.0 + std::cos(elbow));
        q[1] = elbow;
        q[2] = pose[2] - q[0] - q[1];
        return true;
    }

    bool marksCopies_;
};
}  // namespace specplan::test
