// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include "FaultyCode.h"
#include "specplan/planner/SpeculativeAStar.h"

namespace specplan::test
{
namespace ob = ompl::base;

/// Which of the user's classes fails.
enum class Place
{
    Checker,
    Validator,
    Objective,
    Goal,
    Space,
    Termination
};

inline constexpr std::array kPlaces{Place::Checker, Place::Validator, Place::Objective,
                                    Place::Goal,    Place::Space,     Place::Termination};

inline const char* nameOf(Place place)
{
    constexpr std::array kNames{"Checker", "Validator", "Objective", "Goal", "Space", "Termination"};
    return kNames[static_cast<std::size_t>(place)];
}

/// The unit square with a wall that has a gap, or with random discs; one of the user's classes in it fails. States are
/// counted.
class FaultyProblem
{
public:
    /// \param scene 0 for the wall; another number for these discs.
    FaultyProblem(Place place, Fault fault, std::uint64_t seed, std::uint64_t scene)
        : code(fault, seed),
          space(std::make_shared<Space>(*this)),
          si(std::make_shared<ob::SpaceInformation>(space)),
          place_(place),
          discs_(makeDiscs(scene))
    {
        space->setBounds(0.0, 1.0);
        si->setStateValidityChecker(std::make_shared<Checker>(*this));
        if (place == Place::Validator)
            si->setMotionValidator(std::make_shared<Validator>(*this));
        si->setStateValidityCheckingResolution(0.01);
        si->setup();
        pdef = std::make_shared<ob::ProblemDefinition>(si);
        const ob::ScopedState<> start = at(0.1, 0.1);
        pdef->addStartState(start);
        const auto goal = std::make_shared<Goal>(*this);
        goal->setState(at(0.9, 0.2));
        if (place == Place::Goal)
            goal->setThreshold(0.08);  // lattice states may satisfy it, so it is asked for each
        pdef->setGoal(goal);
        if (place == Place::Objective)
            pdef->setOptimizationObjective(std::make_shared<Objective>(*this));
    }

    /// States that were made and not freed, of all problems of the process.
    static std::int64_t livingStates()
    {
        return living_;
    }

    void makePlanner(unsigned threads, const std::string& evaluation)
    {
        PlannerSettings settings;
        settings.numThreads = threads;
        settings.evaluation = evaluation;
        settings.resolution = 0.05;
        settings.anytime = false;
        settings.weight = 1.0;
        planner = std::make_shared<SpeculativeAStar>(si, settings);
        planner->setProblemDefinition(pdef);
        planner->setup();
    }

    ob::PlannerStatus solve()
    {
        armed_ = true;
        const auto timed = ob::timedPlannerTerminationCondition(60.0);
        const ob::PlannerStatus status = planner->solve(ob::PlannerTerminationCondition(
            [&]
            {
                act(Place::Termination, nullptr);
                return timed();
            }));
        armed_ = false;
        return status;
    }

    [[nodiscard]] ompl::geometric::PathGeometric& path() const
    {
        return *pdef->getSolutionPath()->as<ompl::geometric::PathGeometric>();
    }

    FaultyCode code;
    std::shared_ptr<ob::RealVectorStateSpace> space;
    ob::SpaceInformationPtr si;
    ob::ProblemDefinitionPtr pdef;
    std::shared_ptr<SpeculativeAStar> planner;

private:
    struct Disc
    {
        double x;
        double y;
        double radius;

        [[nodiscard]] bool holds(double atX, double atY) const
        {
            return std::hypot(atX - x, atY - y) < radius;
        }
    };

    class Space : public ob::RealVectorStateSpace
    {
    public:
        explicit Space(FaultyProblem& problem) : ob::RealVectorStateSpace(2), problem_(problem)
        {
        }

        ob::State* allocState() const override
        {
            problem_.act(Place::Space, nullptr);
            ++living_;
            return ob::RealVectorStateSpace::allocState();
        }

        void freeState(ob::State* state) const override
        {
            --living_;
            ob::RealVectorStateSpace::freeState(state);
        }

        double distance(const ob::State* a, const ob::State* b) const override
        {
            const double distance = ob::RealVectorStateSpace::distance(a, b);
            return problem_.act(Place::Space, nullptr) ? 1.1 * distance : distance;
        }

        void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* out) const override
        {
            problem_.act(Place::Space, nullptr);
            ob::RealVectorStateSpace::interpolate(from, to, t, out);
        }

    private:
        FaultyProblem& problem_;
    };

    class Checker : public ob::StateValidityChecker
    {
    public:
        explicit Checker(FaultyProblem& problem) : ob::StateValidityChecker(problem.si), problem_(problem)
        {
        }

        bool isValid(const ob::State* state) const override
        {
            const double* at = state->as<ob::RealVectorStateSpace::StateType>()->values;
            const bool valid = problem_.isFree(at[0], at[1]);
            return valid != problem_.act(Place::Checker, state);
        }

    private:
        FaultyProblem& problem_;
    };

    class Validator : public ob::DiscreteMotionValidator
    {
    public:
        explicit Validator(FaultyProblem& problem) : ob::DiscreteMotionValidator(problem.si), problem_(problem)
        {
        }

        bool checkMotion(const ob::State* from, const ob::State* to) const override
        {
            const bool valid = ob::DiscreteMotionValidator::checkMotion(from, to);
            return valid != problem_.act(Place::Validator, to);
        }

    private:
        FaultyProblem& problem_;
    };

    class Objective : public ob::OptimizationObjective
    {
    public:
        explicit Objective(FaultyProblem& problem) : ob::OptimizationObjective(problem.si), problem_(problem)
        {
        }

        ob::Cost stateCost(const ob::State*) const override
        {
            return ob::Cost(1.0);
        }

        ob::Cost motionCost(const ob::State* from, const ob::State* to) const override
        {
            const double length = si_->distance(from, to);
            return ob::Cost(problem_.act(Place::Objective, to) ? 3.0 * length : length);
        }

    private:
        FaultyProblem& problem_;
    };

    class Goal : public ob::GoalState
    {
    public:
        explicit Goal(FaultyProblem& problem) : ob::GoalState(problem.si), problem_(problem)
        {
        }

        double distanceGoal(const ob::State* state) const override
        {
            const double distance = ob::GoalState::distanceGoal(state);
            return problem_.act(Place::Goal, state) ? distance + 1.0 : distance;
        }

        void sampleGoal(ob::State* state) const override
        {
            problem_.act(Place::Goal, nullptr);
            ob::GoalState::sampleGoal(state);
        }

    private:
        FaultyProblem& problem_;
    };

    /// Called by the user's classes. \return whether the answer is to be another one.
    bool act(Place place, const ob::State* state)
    {
        return armed_ && place == place_ && code.act(*si, state);
    }

    /// None of them over start or goal.
    static std::vector<Disc> makeDiscs(std::uint64_t scene)
    {
        std::mt19937_64 random(scene);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        std::vector<Disc> discs;
        for (int i = 0; i < (scene == 0 ? 0 : 12); ++i)
        {
            const Disc disc{unit(random), unit(random), 0.05 + 0.15 * unit(random)};
            if (!disc.holds(0.1, 0.1) && !disc.holds(0.9, 0.2))
                discs.push_back(disc);
        }
        return discs;
    }

    [[nodiscard]] bool isFree(double x, double y) const
    {
        if (discs_.empty())
            return std::abs(x - 0.5) > 0.06 || y > 0.8;
        return std::ranges::none_of(discs_, [x, y](const Disc& disc) { return disc.holds(x, y); });
    }

    [[nodiscard]] ob::ScopedState<> at(double x, double y) const
    {
        ob::ScopedState<> state(space);
        state[0] = x;
        state[1] = y;
        return state;
    }

    static inline std::atomic<std::int64_t> living_{0};
    Place place_;
    std::vector<Disc> discs_;
    std::atomic<bool> armed_{false};
};
}  // namespace specplan::test
