// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "ReferenceAStar.h"
#include "specplan/lattice/GridHeuristic.h"
#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/lattice/Lattice.h"
#include "specplan/util/Hash.h"
#include "specplan/validity/Checker.h"

namespace specplan::test
{
/// Problems to try; fewer where a sanitizer slows everything down, more in a soak.
inline std::uint64_t problemCount()
{
    if (const char* wanted = std::getenv("SPECPLAN_RANDOM_PROBLEMS"))
        return std::strtoull(wanted, nullptr, 10);
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    return 200;
#else
    return 2000;
#endif
}

/// What a problem tells of a motion's cost before it is checked.
enum class CostsBefore
{
    Known,
    Distance,  ///< at least the distance; the cost is up to a third more
    Nothing    ///< at least 0; the cost is that of going uphill, so that many ways differ by rounding only

};

/// A box of cells with random obstacles, random bad motions, several starts and goals; everything follows from the
/// seed.
class RandomProblem
{
public:
    explicit RandomProblem(std::uint64_t seed, CostsBefore costs = CostsBefore::Known) : seed_(seed), costs_(costs)
    {
        std::mt19937_64 random(seed);
        const auto below = [&random](std::uint64_t n) { return static_cast<int>(random() % n); };
        const int dimension = 2 + below(2);
        for (int axis = 0; axis < dimension; ++axis)
            size_.push_back(dimension == 2 ? 3 + below(20) : 2 + below(6));
        density_ = static_cast<double>(below(61)) / 100.0;
        motionDensity_ = below(2) == 0 ? 0.0 : static_cast<double>(below(20)) / 100.0;
        weight_ = std::vector<double>{1.0, 1.5, 10.0}[static_cast<std::size_t>(below(3))];
        connectivity_ = static_cast<unsigned>(1 + below(static_cast<std::uint64_t>(dimension)));
        cornerCutting_ = below(3) != 0;
        for (int axis = 0; axis < dimension; ++axis)
            spacing_.push_back(below(2) == 0 ? 1.0 : 0.5 + 0.25 * below(5));
        const auto randomCell = [&]
        {
            Cell cell;
            for (const int size : size_)
                cell.push_back(below(static_cast<std::uint64_t>(size)));
            return cell;
        };
        for (int i = 1 + below(2); i > 0; --i)
            starts_.push_back(randomCell());
        for (int i = 1 + below(3); i > 0; --i)
            goals_.insert(randomCell());  // valid or not, reachable or not
    }

    [[nodiscard]] const std::vector<Cell>& starts() const
    {
        return starts_;
    }
    [[nodiscard]] const std::set<Cell>& goals() const
    {
        return goals_;
    }
    [[nodiscard]] double weight() const
    {
        return weight_;
    }

    /// Starts count as valid: the search is told so.
    [[nodiscard]] bool isStateValid(const Cell& cell) const
    {
        return std::find(starts_.begin(), starts_.end(), cell) != starts_.end() || draw(cell, 1) >= density_;
    }

    [[nodiscard]] bool isMotionValid(const Cell& from, const Cell& to) const
    {
        return motionDensity_ == 0.0 ||
               static_cast<double>(util::mix(draw64(from, 2), draw64(to, 3))) * 0x1p-64 >= motionDensity_;
    }

    /// What a valid motion costs.
    [[nodiscard]] double motionCost(const Cell& from, const Cell& to) const
    {
        switch (costs_)
        {
            case CostsBefore::Known:
                break;
            case CostsBefore::Distance:
                return distance(from, to) *
                       (1.0 + 0.1 * static_cast<double>(util::mix(draw64(from, 4), draw64(to, 5)) % 4));
            case CostsBefore::Nothing:
                return std::max(height(to) - height(from), 0.0) + 0.1 * distance(from, to);
        }
        return distance(from, to);
    }

    /// What is known of that without a check.
    [[nodiscard]] double lowerBound(const Cell& from, const Cell& to) const
    {
        return costs_ == CostsBefore::Nothing ? 0.0 : distance(from, to);
    }

    [[nodiscard]] CostsBefore costs() const
    {
        return costs_;
    }

    [[nodiscard]] lattice::GridSteps steps() const
    {
        lattice::GridSteps steps;
        steps.connectivity = connectivity_;
        steps.cornerCutting = cornerCutting_;
        steps.cost = [this](std::span<const lattice::Coordinate> offset) {
            return stepCost({offset.begin(), offset.end()});
        };
        steps.motionCheck = [this](std::span<const lattice::Coordinate>) { return motionDensity_ > 0.0; };
        return steps;
    }

    [[nodiscard]] lattice::GridBox box() const
    {
        lattice::GridBox box{std::vector<lattice::Coordinate>(size_.size(), 0), {}};
        for (const int size : size_)
            box.upper.push_back(size - 1);
        return box;
    }

    [[nodiscard]] lattice::GridHeuristic heuristic(const lattice::Lattice& lattice) const
    {
        lattice::GridHeuristic heuristic(lattice, known(spacing_), connectivity_);
        for (const Cell& goal : goals_)
            heuristic.addGoal({std::vector<double>(goal.begin(), goal.end()), {}});
        return heuristic;
    }

    /// The same problem for the reference search, with neighbours of its own making.
    [[nodiscard]] CellProblem forReference() const
    {
        return {starts_,
                goals_,
                weight_,
                [this](const Cell& cell) { return successors(cell); },
                [this](const Cell& cell) { return estimate(cell); },
                [this](const Cell& cell) { return isStateValid(cell); },
                [this](const Cell& from, const Cell& to) { return cornersValid(from, to) && isMotionValid(from, to); }};
    }

private:
    [[nodiscard]] std::uint64_t draw64(const Cell& cell, std::uint64_t salt) const
    {
        return util::mix(util::mix(seed_, salt),
                         util::hashCoordinates(std::vector<std::int32_t>(cell.begin(), cell.end())));
    }

    [[nodiscard]] double draw(const Cell& cell, std::uint64_t salt) const
    {
        return static_cast<double>(draw64(cell, salt)) * 0x1p-64;
    }

    [[nodiscard]] static double height(const Cell& cell)
    {
        double height = 0.0;
        for (const int coordinate : cell)
            height += 0.37 * coordinate;
        return height;
    }

    [[nodiscard]] double distance(const Cell& from, const Cell& to) const
    {
        Cell offset;
        for (std::size_t axis = 0; axis < from.size(); ++axis)
            offset.push_back(to[axis] - from[axis]);
        return stepCost(offset);
    }

    [[nodiscard]] double stepCost(const Cell& offset) const
    {
        double squared = 0.0;
        for (std::size_t axis = 0; axis < offset.size(); ++axis)
            squared += offset[axis] * spacing_[axis] * (offset[axis] * spacing_[axis]);
        return std::sqrt(squared);
    }

    /// The spacing as the heuristic knows it: without a bound on costs there is no estimate but 0.
    [[nodiscard]] std::vector<double> known(const std::vector<double>& spacing) const
    {
        return costs_ == CostsBefore::Nothing ? std::vector<double>(spacing.size(), 0.0) : spacing;
    }

    [[nodiscard]] double estimate(const Cell& cell) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Cell& goal : goals_)
        {
            std::vector<double> distance;
            for (std::size_t axis = 0; axis < cell.size(); ++axis)
                distance.push_back(goal[axis] - cell[axis]);
            nearest = std::min(nearest, lattice::gridDistance(distance, known(spacing_), connectivity_));
        }
        return nearest;
    }

    void forEachOffset(const std::function<void(const Cell&)>& visit) const
    {
        Cell offset(size_.size(), 0);
        const std::function<void(std::size_t)> fill = [&](std::size_t axis)
        {
            if (axis == offset.size())
                return visit(offset);
            for (offset[axis] = -1; offset[axis] <= 1; ++offset[axis])
                fill(axis + 1);
        };
        fill(0);
    }

    [[nodiscard]] bool inside(const Cell& cell) const
    {
        for (std::size_t axis = 0; axis < cell.size(); ++axis)
            if (cell[axis] < 0 || cell[axis] >= size_[axis])
                return false;
        return true;
    }

    [[nodiscard]] std::vector<std::pair<Cell, double>> successors(const Cell& cell) const
    {
        std::vector<std::pair<Cell, double>> out;
        forEachOffset(
            [&](const Cell& offset)
            {
                Cell next = cell;
                unsigned changed = 0;
                for (std::size_t axis = 0; axis < cell.size(); ++axis)
                {
                    next[axis] += offset[axis];
                    changed += offset[axis] != 0 ? 1 : 0;
                }
                if (changed >= 1 && changed <= connectivity_ && inside(next))
                    out.emplace_back(next, motionCost(cell, next));
            });
        return out;
    }

    [[nodiscard]] bool cornersValid(const Cell& from, const Cell& to) const
    {
        if (cornerCutting_)
            return true;
        bool valid = true;
        forEachOffset(
            [&](const Cell& offset)
            {
                Cell corner = from;
                bool between = true;
                for (std::size_t axis = 0; axis < from.size(); ++axis)
                {
                    between = between && (offset[axis] == 0 || offset[axis] == to[axis] - from[axis]);
                    corner[axis] += offset[axis];
                }
                if (between && corner != from && corner != to)
                    valid = valid && isStateValid(corner);
            });
        return valid;
    }

    std::uint64_t seed_;
    CostsBefore costs_;
    Cell size_;
    double density_;
    double motionDensity_;
    double weight_;
    unsigned connectivity_;
    bool cornerCutting_;
    std::vector<double> spacing_;
    std::vector<Cell> starts_;
    std::set<Cell> goals_;
};

inline Cell cellOf(const lattice::Lattice& lattice, lattice::NodeId node)
{
    const auto coordinates = lattice.coordinates(node);
    return {coordinates.begin(), coordinates.end()};
}

/// The costs of a problem where only a check tells them.
class ProblemCosts : public lattice::MotionCosts
{
public:
    ProblemCosts(const RandomProblem& problem, const lattice::Lattice& lattice) : problem_(problem), lattice_(lattice)
    {
    }

    void makeRoom(std::size_t) override
    {
    }

    [[nodiscard]] double lowerBound(lattice::NodeId from, lattice::NodeId to) const override
    {
        return problem_.lowerBound(cellOf(lattice_, from), cellOf(lattice_, to));
    }

    [[nodiscard]] double known(lattice::MotionId motion) const override
    {
        const lattice::Lattice::Motion& asked = lattice_.motion(motion);
        return problem_.motionCost(cellOf(lattice_, asked.from), cellOf(lattice_, asked.to));
    }

private:
    const RandomProblem& problem_;
    const lattice::Lattice& lattice_;
};

/// Answers the checks of one problem after another, and proves the promises about calls: at most once per check, at
/// most `limit` at once, none while closed.
class ProblemChecker : public validity::Checker
{
public:
    /// \param delay whether checks last a random while.
    explicit ProblemChecker(unsigned limit, bool delay) : limit_(limit), delay_(delay)
    {
    }

    void open(const RandomProblem& problem, const lattice::Lattice& lattice)
    {
        problem_ = &problem;
        lattice_ = &lattice;
        called_ = std::vector<std::atomic<int>>(1U << 16U);
        calls_ = 0;
        open_ = true;
    }

    void close()
    {
        open_ = false;
    }

    bool check(validity::CheckId check, unsigned worker) override
    {
        violations_ += worker >= limit_ ? 1 : 0;
        violations_ += ++running_ > static_cast<int>(limit_) ? 1 : 0;
        violations_ += open_ ? 0 : 1;
        const std::size_t index = check.isMotion() ? 8192U + check.motion() : check.node();
        if (index < called_.size())
            violations_ += called_[index]++ > 0 ? 1 : 0;
        if (const auto n = ++calls_; delay_ && n % 7 == 0)
            delay(std::chrono::microseconds(n % 60));
        const auto cell = [this](lattice::NodeId node) { return cellOf(*lattice_, node); };
        bool valid = check.isMotion() ? problem_->isMotionValid(cell(lattice_->motion(check.motion()).from),
                                                                cell(lattice_->motion(check.motion()).to))
                                      : problem_->isStateValid(cell(check.node()));
        if (check.isMotion() && lattice_->isGlance(check.motion()))
        {
            ++glances_;
            // It misses half of what there is to see.
            valid = valid || util::hashCoordinates(lattice_->coordinates(lattice_->motion(check.motion()).to)) % 2 == 0;
        }
        --running_;
        return valid;
    }

    [[nodiscard]] unsigned glances() const
    {
        return glances_;
    }

    [[nodiscard]] int violations() const
    {
        return violations_;
    }

private:
    /// Sleeping would take longer than asked for.
    static void delay(std::chrono::microseconds time)
    {
        const auto end = std::chrono::steady_clock::now() + time;
        while (std::chrono::steady_clock::now() < end)
            std::this_thread::yield();
    }

    unsigned limit_;
    bool delay_;
    const RandomProblem* problem_ = nullptr;
    const lattice::Lattice* lattice_ = nullptr;
    std::vector<std::atomic<int>> called_;
    std::atomic<unsigned> calls_{0};
    std::atomic<unsigned> glances_{0};
    std::atomic<int> running_{0};
    std::atomic<int> violations_{0};
    std::atomic<bool> open_{false};
};
}  // namespace specplan::test
