// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/LatticeQuery.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "specplan/speculation/DirectionPolicy.h"
#include "specplan/speculation/LearningPredictor.h"
#include "specplan/speculation/NearbyPredictor.h"
#include "specplan/speculation/RunAheadPolicy.h"

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::Coordinate;
using lattice::NodeId;
using validity::CheckId;

namespace
{
/// A motion this close to one segment is left to the check, which counts the segments from the real states.
constexpr double kSegmentSlack = 1.0 - 1e-9;
}  // namespace

LatticeQuery::LatticeQuery(const ob::SpaceInformation& si, ob::OptimizationObjectivePtr objective,
                           const PlannerSettings& settings, validity::Executor& executor, OmplChecker& checker,
                           OmplChecker::Sources sources, const ob::State* origin)
    : si_(si),
      objective_(std::move(objective)),
      settings_(settings),
      embedding_(si, settings, origin),
      lattice_(makeNeighbourhood(isDiscreteMotionValidator(*sources.motionValidators.front()))),
      broker_(executor),
      predictor_(makePredictor()),
      gridHeuristic_(lattice_, embedding_.spacing(), embedding_.connectivity()),
      objectiveHeuristic_(si, *objective_, lattice_, embedding_, goalStates_)
{
    if (!isPathLength(*objective_))
    {
        motionCost_.emplace(si_, *objective_, lattice_, embedding_);
        lattice_.setStepCost(*motionCost_);
    }
    checker.open(lattice_, embedding_, std::move(sources));
    broker_.setBarrier(settings.barrier);
    speculates_ = !executor.runsInline();
    beginSearch();
}

std::unique_ptr<speculation::Predictor> LatticeQuery::makePredictor()
{
    if (settings_.predictor == "optimistic")
        return std::make_unique<speculation::OptimisticPredictor>();
    if (settings_.predictor == "nearby")
        return std::make_unique<speculation::NearbyPredictor>(lattice_);
    return std::make_unique<speculation::LearningPredictor>(lattice_);
}

std::unique_ptr<speculation::Policy> LatticeQuery::makePolicy()
{
    if (speculates_ && settings_.speculationPolicy == "direction")
        return std::make_unique<speculation::DirectionPolicy>(lattice_, broker_, settings_.lookahead);
    if (speculates_ && settings_.speculationPolicy == "runahead")
        return std::make_unique<speculation::RunAheadPolicy>(lattice_, broker_, *search_, *predictor_,
                                                             settings_.weight);
    return nullptr;
}

std::unique_ptr<lattice::GridNeighbourhood> LatticeQuery::makeNeighbourhood(bool discreteMotions) const
{
    lattice::GridSteps steps;
    steps.connectivity = embedding_.connectivity();
    steps.cornerCutting = settings_.cornerCutting;
    steps.cost = [this](std::span<const Coordinate> offset) { return embedding_.stepLength(offset); };
    const double segment =
        si_.getStateSpace()->getLongestValidSegmentLength() / si_.getStateSpace()->getValidSegmentCountFactor();
    steps.motionCheck = [this, discreteMotions, segment](std::span<const Coordinate> offset)
    { return !discreteMotions || embedding_.stepLength(offset) > segment * kSegmentSlack; };
    return std::make_unique<lattice::GridNeighbourhood>(embedding_.box(), steps);
}

std::optional<NodeId> LatticeQuery::nodeExactlyAt(const ob::State* state)
{
    const std::vector<double> position = embedding_.position(state);
    std::vector<Coordinate> coordinates;
    coordinates.reserve(position.size());
    for (const double axis : position)
        coordinates.push_back(static_cast<Coordinate>(std::round(axis)));
    if (!embedding_.contains(coordinates))
        return std::nullopt;
    const NodeId node = lattice_.node(coordinates.data());
    // Bit by bit: a path has to end in the very state that was asked for.
    std::vector<double> there;
    std::vector<double> wanted;
    si_.getStateSpace()->copyToReals(there, stateOf(node).get());
    si_.getStateSpace()->copyToReals(wanted, state);
    if (there != wanted)
        return std::nullopt;
    return node;
}

NodeId LatticeQuery::addTerminal(const ob::State* state)
{
    embedding_.addTerminal(state);
    return lattice_.addTerminal();
}

void LatticeQuery::join(NodeId from, NodeId to)
{
    const StateHandle first = stateOf(from);
    const StateHandle second = stateOf(to);
    const double cost = motionCost_ ? (*motionCost_)(from, to) : si_.distance(first.get(), second.get());
    lattice_.connect(from, to, cost);
}

void LatticeQuery::joinNeighbours(NodeId start, NodeId goal)
{
    if (!lattice_.isTerminal(start) || !lattice_.isTerminal(goal))
        return;
    const std::vector<double> from = embedding_.position(stateOf(start).get());
    const std::vector<double> to = embedding_.position(stateOf(goal).get());
    for (std::size_t axis = 0; axis < from.size(); ++axis)
        if (std::abs(to[axis] - from[axis]) > 1.0)
            return;
    join(start, goal);
}

void LatticeQuery::addStart(const ob::State* state)
{
    std::optional<NodeId> node = nodeExactlyAt(state);
    if (!node)
    {
        node = addTerminal(state);
        for (const auto& corner : embedding_.corners(embedding_.position(state)))
            join(*node, lattice_.node(corner.data()));
        for (const NodeId goal : goalNodes_)
            joinNeighbours(*node, goal);
    }
    broker_.setVerdict(CheckId::ofState(*node), true);
    startNodes_.push_back(*node);
}

void LatticeQuery::addGoal(const ob::State* state)
{
    const std::vector<double> position = embedding_.position(state);
    lattice::GridHeuristic::Goal target{position, {}};
    std::optional<NodeId> node = nodeExactlyAt(state);
    if (!node)
    {
        node = addTerminal(state);
        for (const auto& corner : embedding_.corners(position))
        {
            join(lattice_.node(corner.data()), *node);
            std::vector<double>& approach = target.approaches.emplace_back();
            std::ranges::transform(position, corner, std::back_inserter(approach), std::minus<double>());
        }
        for (const NodeId start : startNodes_)
            joinNeighbours(start, *node);
    }
    gridHeuristic_.addGoal(std::move(target));
    goalStates_.emplace_back(si_, state);
    broker_.setVerdict(CheckId::ofState(*node), true);
    goalNodes_.push_back(*node);
}

void LatticeQuery::beginSearch()
{
    const lattice::Heuristic& heuristic =
        motionCost_ ? static_cast<const lattice::Heuristic&>(objectiveHeuristic_) : gridHeuristic_;
    search_ = std::make_unique<search::AStar>(lattice_, heuristic, broker_, settings_.weight);
    policy_ = makePolicy();
    broker_.setSource(policy_.get());
    search_->setPolicy(policy_.get());
    for (const NodeId goal : goalNodes_)
        search_->addGoal(goal);
    for (const NodeId start : startNodes_)
        search_->addStart(start);
}

StateHandle LatticeQuery::stateOf(NodeId node) const
{
    StateHandle state(si_);
    embedding_.write(lattice_, node, state.get());
    return state;
}

double LatticeQuery::distanceToGoal(const ob::State* state) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const StateHandle& goal : goalStates_)
        nearest = std::min(nearest, si_.distance(state, goal.get()));
    return nearest;
}

bool LatticeQuery::comesBefore(NodeId node, NodeId other) const
{
    const double g = search_->costToCome(node);
    const double otherG = search_->costToCome(other);
    return g != otherG ? g < otherG
                       : std::ranges::lexicographical_compare(lattice_.coordinates(node), lattice_.coordinates(other));
}

LatticeQuery::Nearest LatticeQuery::nearestToGoal() const
{
    Nearest nearest{lattice::kNoNode, std::numeric_limits<double>::infinity()};
    for (NodeId node = 0; node < lattice_.size(); ++node)
    {
        if (!std::isfinite(search_->costToCome(node)))
            continue;
        const double distance = distanceToGoal(stateOf(node).get());
        if (distance < nearest.distance || (distance == nearest.distance && comesBefore(node, nearest.node)))
            nearest = {node, distance};
    }
    return nearest;
}
}  // namespace specplan::planner
