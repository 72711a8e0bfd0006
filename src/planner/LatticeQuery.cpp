// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/LatticeQuery.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "specplan/planner/Distance.h"
#include "specplan/planner/LatticeFit.h"
#include "specplan/planner/PathProof.h"
#include "specplan/speculation/DirectionPolicy.h"
#include "specplan/speculation/HedgedPolicy.h"
#include "specplan/speculation/LearningPredictor.h"
#include "specplan/speculation/NearbyPredictor.h"

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::NodeId;
using validity::CheckId;

namespace
{
/// Weight by the number of axes, where none was asked for: the more there are, the less a lattice can be searched
/// through.
double automaticWeight(unsigned axes)
{
    if (axes <= kFewAxes)
        return 1.0;
    return axes <= 7 ? 3.0 : 5.0;
}

/// Weight for a first path, soon to be bettered.
constexpr double kHasty = 10.0;

/// Weight where nobody has asked for a best path.
constexpr double kAnyPath = 3.0;

/// Bit by bit: a path has to end in the very state that was asked for.
bool sameValues(const ob::StateSpace& space, const ob::State* a, const ob::State* b)
{
    std::vector<double> ofA;
    std::vector<double> ofB;
    space.copyToReals(ofA, a);
    space.copyToReals(ofB, b);
    return ofA == ofB && space.equalStates(a, b);
}
}  // namespace

LatticeQuery::LatticeQuery(const ob::SpaceInformation& si, ob::OptimizationObjectivePtr objective,
                           const PlannerSettings& settings, const SpaceHooks& hooks, validity::Executor& executor,
                           OmplChecker& checker, OmplChecker::Sources sources, const ob::State* origin, bool coarsens)
    : si_(si),
      objective_(std::move(objective)),
      settings_(settings),
      discreteMotions_(isDiscreteMotionValidator(*sources.motionValidators.front())),
      embedding_(si, settings, hooks, origin, coarsens),
      lattice_(embedding_.neighbourhood(discreteMotions_)),
      costs_(isPathLength(*objective_) ? std::nullopt
                                       : std::make_optional<ObjectiveCosts>(si, *objective_, lattice_, embedding_)),
      from_(si),
      to_(si),
      broker_(executor),
      predictor_(makePredictor()),
      heuristic_(si, *objective_, lattice_, embedding_, costs_ ? &*costs_ : nullptr)
{
    requireFit(si, embedding_, origin);
    if (costs_ && settings_.objectiveInChecks)
        lattice_.setMotionCosts(&*costs_);
    else if (costs_ || !embedding_.sumsDistances())
        lattice_.setStepCost([this](NodeId from, NodeId to) { return motionCost(from, to); });
    lattice_.setGlances(settings_.evaluation == "lazy" && discreteMotions_);
    checker.open(lattice_, embedding_, std::move(sources), costs_ && settings_.objectiveInChecks ? &*costs_ : nullptr);
    broker_.setBarrier(settings.barrier);
    workers_ = executor.workers();
    speculates_ = !executor.runsInline();
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
        return speculation::makeRunAhead(lattice_, broker_, *eager_, *predictor_, weight_, workers_);
    return nullptr;
}

double LatticeQuery::firstWeight(Wish wish) const
{
    if (settings_.weight > 0.0)
        return settings_.weight;
    const double automatic = automaticWeight(embedding_.axes());
    if (!addsCosts() || wish == Wish::BestPath)
        return automatic;
    return std::max(automatic, wish == Wish::BetterPaths ? kHasty : kAnyPath);
}

void LatticeQuery::beginQuery()
{
    dropSearch();
    broker_.beginQuery();
    lattice_.disconnectAll();
    heuristic_.clear();
    goal_.reset();
    startStates_.clear();
    goalStates_.clear();
    startNodes_.clear();
    goalNodes_.clear();
}

std::optional<NodeId> LatticeQuery::nodeExactlyAt(const ob::State* state,
                                                  const std::vector<Embedding::Coordinates>& corners)
{
    if (corners.empty())
        return std::nullopt;
    const NodeId node = lattice_.node(corners.front().data());
    if (!sameValues(*si_.getStateSpace(), stateOf(node).get(), state))
        return std::nullopt;
    return node;
}

NodeId LatticeQuery::terminalAt(const ob::State* state)
{
    for (std::size_t i = 0; i < terminals_.size(); ++i)
        if (sameValues(*si_.getStateSpace(), terminalStates_[i].get(), state))
            return terminals_[i];
    embedding_.addTerminal(state);
    terminalStates_.emplace_back(si_, state);
    return terminals_.emplace_back(lattice_.addTerminal());
}

double LatticeQuery::motionCost(NodeId from, NodeId to) const
{
    embedding_.write(lattice_, from, from_.get());
    embedding_.write(lattice_, to, to_.get());
    if (costs_)
        return costs_->ofMotion(from_.get(), to, to_.get());
    return distance(si_, from_.get(), to_.get());
}

void LatticeQuery::join(NodeId from, NodeId to)
{
    lattice_.connect(from, to, motionCost(from, to));
    if (eager_ != nullptr)
        eager_->motionAdded(from);
}

void LatticeQuery::joinToLattice(NodeId terminal, Embedding::Joint joint,
                                 const std::vector<Embedding::Coordinates>& corners)
{
    for (const Embedding::Coordinates& corner : corners)
    {
        const NodeId node = lattice_.node(corner.data());
        if (joint == Embedding::Joint::Leaving)
            join(terminal, node);
        else
            join(node, terminal);
    }
}

void LatticeQuery::joinNeighbours(NodeId start, NodeId goal)
{
    if (!lattice_.isTerminal(start) || !lattice_.isTerminal(goal) || start == goal)
        return;
    const auto leaving = embedding_.corners(stateOf(start).get(), Embedding::Joint::Leaving);
    const auto entering = embedding_.corners(stateOf(goal).get(), Embedding::Joint::Entering);
    if (std::ranges::find_first_of(leaving, entering) != leaving.end())
        join(start, goal);
}

NodeId LatticeQuery::nodeFor(const ob::State* state, Embedding::Joint joint)
{
    const std::vector<Embedding::Coordinates> corners = embedding_.corners(state, joint);
    const bool ends = joint == Embedding::Joint::Entering && costs_ &&
                      objective_->terminalCost(state).value() != objective_->identityCost().value();
    std::optional<NodeId> node = ends ? std::nullopt : nodeExactlyAt(state, corners);
    if (!node)
    {
        node = terminalAt(state);
        if (ends)
            costs_->setTerminalCost(*node, costs_->number(objective_->terminalCost(state)));
        joinToLattice(*node, joint, corners);
    }
    broker_.setVerdict(CheckId::ofState(*node), true);
    return *node;
}

void LatticeQuery::addStart(const ob::State* state)
{
    const NodeId node = nodeFor(state, Embedding::Joint::Leaving);
    for (const NodeId goal : goalNodes_)
        joinNeighbours(node, goal);
    startStates_.emplace_back(si_, state);
    startNodes_.push_back(node);
}

void LatticeQuery::requireWholeStates() const
{
    if (!embedding_.writesWholeStates() && !lattice_.isTerminal(startNodes_.front()))
        requireComplete(si_, stateOf(startNodes_.front()).get(), startStates_.front().get());
}

void LatticeQuery::addGoal(const ob::State* state)
{
    const NodeId node = nodeFor(state, Embedding::Joint::Entering);
    for (const NodeId start : startNodes_)
        joinNeighbours(start, node);
    heuristic_.addState(state);
    goalStates_.emplace_back(si_, state);
    goalNodes_.push_back(node);
    if (eager_ != nullptr)
        eager_->addGoal(node);
}

void LatticeQuery::setGoal(const ob::GoalPtr& goal, bool region)
{
    goal_ = goal;
    region_ = region;
    heuristic_.setGoal(goal.get(), region, startStates_.front().get());
}

void LatticeQuery::goalsChanged()
{
    if (eager_ != nullptr)
        eager_->heuristicChanged();
    else
        beginSearch(weight_);
}

void LatticeQuery::dropSearch()
{
    broker_.setSource(nullptr);
    policy_.reset();
    eager_ = nullptr;
    lazy_ = nullptr;
    search_.reset();
}

void LatticeQuery::beginSearch(double weight)
{
    dropSearch();
    weight_ = weight;
    if (isLazy())
        beginLazySearch();
    else
        beginEagerSearch();
}

void LatticeQuery::beginEagerSearch()
{
    auto search = std::make_unique<search::AStar>(lattice_, heuristic_, broker_, weight_,
                                                  lattice::CostSum(addsCosts() ? nullptr : &*costs_));
    eager_ = search.get();
    search_ = std::move(search);
    eager_->setReopening(!heuristic_.isConsistent());
    policy_ = makePolicy();
    broker_.setSource(policy_.get());
    eager_->setPolicy(policy_.get());
    if (region_)
        eager_->setGoalTest([this](NodeId node) { return goal_->isSatisfied(stateOf(node).get()); });
    for (const NodeId goal : goalNodes_)
        eager_->addGoal(goal);
    for (std::size_t i = 0; i < startNodes_.size(); ++i)
        eager_->addStart(startNodes_[i], costs_ ? costs_->number(objective_->initialCost(startStates_[i].get())) : 0.0);
}

/// Lazy search wants costs that are known before anything is checked, and goals that are nodes. (States near enough to
/// a goal state are passed over then.)
bool LatticeQuery::canBeLazy() const
{
    return !costs_ && !goalNodes_.empty() && heuristic_.isConsistent();
}

void LatticeQuery::beginLazySearch()
{
    auto search = std::make_unique<search::LazySearch>(lattice_, heuristic_, broker_, weight_);
    lazy_ = search.get();
    search_ = std::move(search);
    if (speculates_ && settings_.speculationPolicy != "none")
        broker_.setSource(lazy_);
    lazy_->setGlances([this](const lattice::Lattice::Motion& motion) { return isWorthAGlance(motion); });
    for (const NodeId goal : goalNodes_)
        lazy_->addGoal(goal);
    for (const NodeId start : startNodes_)
        lazy_->addStart(start);
}

/// A glance has to be far shorter than the check of the motion.
bool LatticeQuery::isWorthAGlance(const lattice::Lattice::Motion& motion) const
{
    constexpr unsigned kLeastShare = 3;
    embedding_.write(lattice_, motion.from, from_.get());
    embedding_.write(lattice_, motion.to, to_.get());
    return embedding_.segments(from_.get(), to_.get()) > kLeastShare * OmplChecker::kGlanceStates;
}

void LatticeQuery::setObserver(std::function<void(NodeId)> observer)
{
    if (eager_ != nullptr)
        eager_->setObserver(std::move(observer));
    else if (!observer)
        lazy_->setObserver({});
    else
        lazy_->setObserver(
            [told = std::move(observer)](CheckId check, bool)
            {
                if (!check.isMotion())
                    told(check.node());
            });
}

bool LatticeQuery::refine()
{
    if (!embedding_.refine())
        return false;
    takeNewSpacing();
    return true;
}

void LatticeQuery::coarsen()
{
    embedding_.coarsen();
    takeNewSpacing();
}

void LatticeQuery::takeNewSpacing()
{
    dropSearch();
    lattice_.disconnectAll();  // terminals have other nodes around them now
    lattice_.setNeighbourhood(embedding_.neighbourhood(discreteMotions_), embedding_.level());
    const std::vector<StateHandle> starts = std::move(startStates_);
    const std::vector<StateHandle> goals = std::move(goalStates_);
    startStates_.clear();
    goalStates_.clear();
    startNodes_.clear();
    goalNodes_.clear();
    heuristic_.clear();
    for (const StateHandle& start : starts)
        addStart(start.get());
    setGoal(goal_, region_);
    for (const StateHandle& goal : goals)
        addGoal(goal.get());
}

void LatticeQuery::successors(NodeId node, lattice::Successors& out) const
{
    lattice_.successors(node, out);
}

StateHandle LatticeQuery::stateOf(NodeId node) const
{
    StateHandle state(si_);
    embedding_.write(lattice_, node, state.get());
    return state;
}

ob::Cost LatticeQuery::costToCome(NodeId node) const
{
    const double cost = search_->costToCome(node);
    return costs_ ? costs_->cost(cost) : ob::Cost(cost);
}

ob::Cost LatticeQuery::costOfMotionTo(NodeId node) const
{
    const NodeId parent = search_->parent(node);
    if (parent == lattice::kNoNode)
        return ob::Cost(0.0);
    if (addsCosts())
        return ob::Cost(search_->costToCome(node) - search_->costToCome(parent));
    return objective_->motionCost(stateOf(parent).get(), stateOf(node).get());
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
    StateHandle state(si_);
    for (NodeId node = 0; node < lattice_.size(); ++node)
    {
        if (search_->costToCome(node) == std::numeric_limits<double>::infinity())
            continue;
        embedding_.write(lattice_, node, state.get());
        const double distance = heuristic_.distance(state.get());
        if (distance < nearest.distance || (distance == nearest.distance && comesBefore(node, nearest.node)))
            nearest = {node, distance};
    }
    return nearest;
}
}  // namespace specplan::planner
