// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <ompl/base/StateSpace.h>

namespace specplan::test
{
namespace ob = ompl::base;

constexpr double kPi = 3.14159265358979323846;

/// A joint of a look-alike of MoveIt's robot models.
struct Joint
{
    enum class Kind
    {
        Revolute,    ///< one value with bounds
        Continuous,  ///< one value that comes round
        Mimic,       ///< one value that another one determines
        Planar,      ///< x, y, angle
        Floating     ///< x, y, z, quaternion
    };

    Kind kind;
    double bound = std::numeric_limits<double>::infinity();  ///< of angles or places, both ways
    std::size_t master = 0;                                  ///< value that a mimic joint follows
    double factor = 1.0;                                     ///< of a mimic joint
    double offset = 0.0;                                     ///< of a mimic joint

    [[nodiscard]] std::size_t values() const noexcept
    {
        return kind == Kind::Planar ? 3 : (kind == Kind::Floating ? 7 : 1);
    }
};

/// A look-alike of MoveIt's joint-space parameterization: one array of values, mimic joints among them, and notes that
/// the checker leaves in the states. As there, copyState() copies the notes, copyFromReals() leaves them as they are,
/// interpolate() clears them, and mimic joints follow only where something else is changed.
class GroupSpace : public ob::StateSpace
{
public:
    enum Flags : unsigned
    {
        ValidityKnown = 1,
        ValidityTrue = 4
    };

    struct StateType : ob::State
    {
        double* values = nullptr;
        unsigned flags = 0;
    };

    explicit GroupSpace(std::vector<Joint> joints) : joints_(std::move(joints))
    {
        setName("group_JointModel");
        for (const Joint& joint : joints_)
        {
            first_.push_back(count_);
            count_ += joint.values();
        }
    }

    static double* valuesOf(ob::State* state)
    {
        return state->as<StateType>()->values;
    }

    static const double* valuesOf(const ob::State* state)
    {
        return state->as<StateType>()->values;
    }

    [[nodiscard]] std::size_t count() const noexcept
    {
        return count_;
    }

    ob::State* allocState() const override
    {
        auto* state = new StateType;
        state->values = new double[count_]();
        return state;
    }

    void freeState(ob::State* state) const override
    {
        delete[] valuesOf(state);
        delete state->as<StateType>();
    }

    void copyState(ob::State* to, const ob::State* from) const override
    {
        std::memcpy(valuesOf(to), valuesOf(from), count_ * sizeof(double));
        to->as<StateType>()->flags = from->as<StateType>()->flags;
    }

    bool equalStates(const ob::State* a, const ob::State* b) const override
    {
        for (std::size_t i = 0; i < count_; ++i)
            if (std::abs(valuesOf(a)[i] - valuesOf(b)[i]) > std::numeric_limits<double>::epsilon())
                return false;
        return true;
    }

    unsigned getDimension() const override
    {
        return static_cast<unsigned>(count_);
    }

    double getMaximumExtent() const override
    {
        return 2.0 * kPi * static_cast<double>(count_);
    }

    double getMeasure() const override
    {
        return 1.0;
    }

    double* getValueAddressAtIndex(ob::State* state, unsigned index) const override
    {
        return index < count_ ? valuesOf(state) + index : nullptr;
    }

    double distance(const ob::State* a, const ob::State* b) const override
    {
        double sum = 0.0;
        for (std::size_t j = 0; j < joints_.size(); ++j)
            sum += distanceOf(joints_[j], valuesOf(a) + first_[j], valuesOf(b) + first_[j]);
        return sum;
    }

    void enforceBounds(ob::State* state) const override
    {
        bool changed = false;
        for (std::size_t j = 0; j < joints_.size(); ++j)
            changed = enforce(joints_[j], valuesOf(state) + first_[j]) || changed;
        if (changed)
            updateMimics(valuesOf(state));
    }

    bool satisfiesBounds(const ob::State* state) const override
    {
        for (std::size_t j = 0; j < joints_.size(); ++j)
            if (!isInside(joints_[j], valuesOf(state) + first_[j]))
                return false;
        return true;
    }

    void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override
    {
        for (std::size_t j = 0; j < joints_.size(); ++j)
            interpolateOf(joints_[j], valuesOf(from) + first_[j], valuesOf(to) + first_[j], t,
                          valuesOf(state) + first_[j]);
        updateMimics(valuesOf(state));
        state->as<StateType>()->flags = 0;
    }

    ob::StateSamplerPtr allocDefaultStateSampler() const override
    {
        return std::make_shared<Sampler>(this);
    }

    void updateMimics(double* values) const
    {
        for (std::size_t j = 0; j < joints_.size(); ++j)
            if (joints_[j].kind == Joint::Kind::Mimic)
                values[first_[j]] = joints_[j].factor * values[joints_[j].master] + joints_[j].offset;
    }

private:
    struct Sampler : ob::StateSampler
    {
        using ob::StateSampler::StateSampler;

        void sampleUniform(ob::State* state) override
        {
            const auto* space = static_cast<const GroupSpace*>(space_);
            for (std::size_t i = 0; i < space->count_; ++i)
                valuesOf(state)[i] = rng_.uniformReal(-1.0, 1.0);
            space->enforceBounds(state);
            space->updateMimics(valuesOf(state));
            state->as<StateType>()->flags = 0;
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

    static double difference(double from, double to)
    {
        return std::remainder(to - from, 2.0 * kPi);
    }

    static bool clampTo(double bound, double& value)
    {
        const double before = value;
        value = std::clamp(value, -bound, bound);
        return value != before;
    }

    static bool bringRound(double& value)
    {
        const double before = value;
        if (value <= -kPi || value > kPi)
            value = std::remainder(value, 2.0 * kPi);
        return value != before;
    }

    static bool normalise(double* q)
    {
        const double squared = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        if (std::abs(squared - 1.0) <= 100.0 * std::numeric_limits<double>::epsilon())
            return false;
        const double norm = std::sqrt(squared);
        if (norm < 1e-9)
            q[0] = q[1] = q[2] = 0.0, q[3] = 1.0;
        else
            for (int i = 0; i < 4; ++i)
                q[i] /= norm;
        return true;
    }

    static bool enforce(const Joint& joint, double* v)
    {
        switch (joint.kind)
        {
            case Joint::Kind::Revolute:
                return clampTo(joint.bound, v[0]);
            case Joint::Kind::Continuous:
                return bringRound(v[0]);
            case Joint::Kind::Mimic:
                return false;
            case Joint::Kind::Planar:
            {
                const bool places = static_cast<int>(clampTo(joint.bound, v[0])) + clampTo(joint.bound, v[1]) > 0;
                return bringRound(v[2]) || places;
            }
            case Joint::Kind::Floating:
                break;
        }
        bool changed = false;
        for (int i = 0; i < 3; ++i)
            changed = clampTo(joint.bound, v[i]) || changed;
        return normalise(v + 3) || changed;
    }

    static bool isInside(const Joint& joint, const double* v)
    {
        constexpr double kSlack = 1e-12;
        const auto within = [&](double value) { return std::abs(value) <= joint.bound + kSlack; };
        switch (joint.kind)
        {
            case Joint::Kind::Revolute:
                return within(v[0]);
            case Joint::Kind::Continuous:
                return true;
            case Joint::Kind::Mimic:
                return true;  // its master is looked at
            case Joint::Kind::Planar:
                return within(v[0]) && within(v[1]);
            case Joint::Kind::Floating:
                break;
        }
        const double squared = v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6];
        return within(v[0]) && within(v[1]) && within(v[2]) && std::abs(squared - 1.0) < kSlack;
    }

    static double distanceOf(const Joint& joint, const double* a, const double* b)
    {
        switch (joint.kind)
        {
            case Joint::Kind::Revolute:
                return std::abs(a[0] - b[0]);
            case Joint::Kind::Continuous:
                return std::abs(difference(a[0], b[0]));
            case Joint::Kind::Mimic:
                return 0.0;
            case Joint::Kind::Planar:
                return std::hypot(a[0] - b[0], a[1] - b[1]) + std::abs(difference(a[2], b[2]));
            case Joint::Kind::Floating:
                break;
        }
        double dot = 0.0;
        for (int i = 3; i < 7; ++i)
            dot += a[i] * b[i];
        return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) + 2.0 * std::acos(std::min(std::abs(dot), 1.0));
    }

    static void interpolateOf(const Joint& joint, const double* from, const double* to, double t, double* out)
    {
        const auto linear = [&](std::size_t i) { out[i] = from[i] + t * (to[i] - from[i]); };
        const auto round = [&](std::size_t i)
        {
            out[i] = from[i] + t * difference(from[i], to[i]);
            bringRound(out[i]);
        };
        switch (joint.kind)
        {
            case Joint::Kind::Revolute:
                return linear(0);
            case Joint::Kind::Continuous:
                return round(0);
            case Joint::Kind::Mimic:
                return;
            case Joint::Kind::Planar:
                return linear(0), linear(1), round(2);
            case Joint::Kind::Floating:
                break;
        }
        double dot = 0.0;
        for (std::size_t i = 3; i < 7; ++i)
            dot += from[i] * to[i];
        for (std::size_t i = 0; i < 7; ++i)
            out[i] = from[i] + t * ((i > 2 && dot < 0.0 ? -to[i] : to[i]) - from[i]);
        normalise(out + 3);
    }

    std::vector<Joint> joints_;
    std::vector<std::size_t> first_;
    std::size_t count_ = 0;
};
}  // namespace specplan::test
