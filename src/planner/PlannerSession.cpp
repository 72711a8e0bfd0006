// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/PlannerSession.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <tuple>

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "specplan/planner/ObjectiveCost.h"
#include "specplan/planner/OmplCompat.h"
#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::planner
{
namespace ob = ompl::base;
namespace og = ompl::geometric;
using lattice::NodeId;
using search::SearchStatus;
using validity::CheckId;
using validity::CheckStatistics;

namespace
{
/// Goals taken from a goal that could be sampled for ever.
constexpr std::size_t kMaxSampledGoals = 16;

auto asTuple(const PlannerSettings& s)
{
    return std::tie(s.numThreads, s.speculationPolicy, s.predictor, s.lookahead, s.barrier, s.weight, s.resolution,
                    s.spacing, s.connectivity, s.cornerCutting, s.executor, s.virtualCheckCost);
}
}  // namespace

void PlannerSession::reset()
{
    query.reset();
    dataStates.clear();
    report = {};
    published = false;
    clockInSearch = 0.0;
    live.expansions = 0;
    live.checksUsed = 0;
    live.speculativeChecks = 0;
    live.bestCost = std::numeric_limits<double>::infinity();
}

void PlannerSession::ensureExecutor()
{
    unsigned threads = settings.numThreads;
    if (threads == 0)
        threads = std::max(std::thread::hardware_concurrency(), 1U);
    if (executor && executorSettings.numThreads == threads && executorSettings.executor == settings.executor &&
        executorSettings.virtualCheckCost == settings.virtualCheckCost)
        return;
    executor.reset();
    checker = std::make_unique<OmplChecker>(*si, threads);
    if (settings.executor == "virtual")
        executor = std::make_unique<validity::VirtualExecutor>(*checker, threads,
                                                               [this, cost = settings.virtualCheckCost](CheckId, bool)
                                                               { return cost * checker->statesOfLastCheck(0); });
    else if (threads == 1)
        executor = std::make_unique<validity::InlineExecutor>(*checker);
    else
        executor = std::make_unique<validity::ThreadPoolExecutor>(*checker, threads);
    executorSettings = settings;
    executorSettings.numThreads = threads;
}

Origins PlannerSession::currentOrigins(const ob::ProblemDefinition& pdef) const
{
    const auto& bounds = si->getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds();
    Origins now{si->getStateValidityChecker(), si->getMotionValidator(), pdef.getOptimizationObjective(), bounds.low,
                si->getStateSpace()->getLongestValidSegmentLength()};
    now.bounds.insert(now.bounds.end(), bounds.high.begin(), bounds.high.end());
    return now;
}

OmplChecker::Sources PlannerSession::makeSources() const
{
    OmplChecker::Sources sources;
    const unsigned workers = executor->workers();
    if (checkerAllocator)
        for (unsigned worker = 0; worker < workers; ++worker)
            sources.checkers.push_back(checkerAllocator(si, worker));
    else
        sources.checkers.push_back(si->getStateValidityChecker());
    if (motionValidatorAllocator)
        for (unsigned worker = 0; worker < workers; ++worker)
            sources.motionValidators.push_back(motionValidatorAllocator(si, worker));
    else
        sources.motionValidators.push_back(si->getMotionValidator());
    for (const auto& made : sources.checkers)
        if (!made)
            throw ompl::Exception("the state validity checker allocator returned nothing");
    for (const auto& made : sources.motionValidators)
        if (!made)
            throw ompl::Exception("the motion validator allocator returned nothing");
    return sources;
}

bool PlannerSession::takeStarts(ob::PlannerInputStates& inputs, const ob::ProblemDefinition& pdef)
{
    bool added = false;
    while (const ob::State* start = inputs.nextStart())
    {
        if (!query)
        {
            ob::OptimizationObjectivePtr objective = pdef.getOptimizationObjective();
            if (objective && !isAdditive(*objective))
            {
                OMPL_WARN("SpeculativeAStar: the objective does not add up costs; the path is planned for length");
                objective.reset();
            }
            if (!objective)
                objective = std::make_shared<ob::PathLengthOptimizationObjective>(si);
            query = std::make_unique<LatticeQuery>(*si, std::move(objective), settings, *executor, *checker,
                                                   makeSources(), start);
        }
        query->addStart(start);
        added = true;
    }
    return added;
}

bool PlannerSession::takeGoals(ob::PlannerInputStates& inputs, const ob::Goal& goal,
                               const ob::PlannerTerminationCondition& ptc)
{
    bool added = false;
    const std::size_t most =
        std::min<std::size_t>(goal.as<ob::GoalSampleableRegion>()->maxSampleCount(),
                              goal.hasType(ob::GOAL_STATES) ? std::size_t{1} << 20 : kMaxSampledGoals);
    const ob::State* state = query->goals().empty() ? inputs.nextGoal(ptc) : inputs.nextGoal();
    for (; state != nullptr; state = inputs.nextGoal())
    {
        query->addGoal(state);
        added = true;
        if (query->goals().size() >= most)
            break;
    }
    return added;
}

std::optional<ob::PlannerStatus> PlannerSession::openQuery(ob::PlannerInputStates& inputs,
                                                           const ob::ProblemDefinition& pdef,
                                                           const ob::PlannerTerminationCondition& ptc)
{
    const Origins now = currentOrigins(pdef);
    if (query && (sourcesChanged || !origins.same(now) || asTuple(querySettings) != asTuple(settings)))
    {
        reset();
        inputs.restart();
    }
    origins = now;
    querySettings = settings;
    sourcesChanged = false;
    const auto refuse = [this](ob::PlannerStatus::StatusType status, const char* name)
    {
        report.status = name;
        return ob::PlannerStatus(status);
    };

    const ob::GoalPtr& goal = pdef.getGoal();
    if (!goal->hasType(ob::GOAL_SAMPLEABLE_REGION))
    {
        OMPL_ERROR("SpeculativeAStar: the goal must be a state, a set of states, or a region that can be sampled");
        return refuse(ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE, "unrecognized goal");
    }
    ensureExecutor();
    if (!query)
        inputs.restart();  // an earlier call may have taken starts and failed
    bool changed = takeStarts(inputs, pdef);
    if (!query)
    {
        OMPL_ERROR("SpeculativeAStar: there is no valid start state");
        return refuse(ob::PlannerStatus::INVALID_START, "invalid start");
    }
    changed = takeGoals(inputs, *goal, ptc) || changed;
    if (query->goals().empty())
    {
        OMPL_ERROR("SpeculativeAStar: there is no valid goal state");
        return refuse(ob::PlannerStatus::INVALID_GOAL, "invalid goal");
    }
    if (changed)
    {
        query->beginSearch();
        published = false;
    }
    return std::nullopt;
}

void PlannerSession::publishCounts()
{
    // Relaxed: each counter stands for itself.
    const CheckStatistics& counts = query->broker().statistics();
    live.expansions.store(query->search().expansions(), std::memory_order_relaxed);
    live.checksUsed.store(counts.checksUsed, std::memory_order_relaxed);
    live.speculativeChecks.store(counts.speculativeChecks, std::memory_order_relaxed);
}

SearchStatus PlannerSession::search(const ob::PlannerTerminationCondition& ptc)
{
    /// Nothing may run any more when solve() is left, whichever way.
    struct Settle
    {
        PlannerSession& session;
        double clock = session.executor->now();

        ~Settle()
        {
            session.clockInSearch += session.executor->now() - clock;
            session.query->broker().settle();
            session.query->broker().setInterrupt({});
            session.query->search().setObserver({});
            session.publishCounts();
        }
    };
    const Settle settle{*this};
    query->broker().setInterrupt([&ptc] { return ptc(); });
    if (observer)
        query->search().setObserver([this](NodeId node) { observer(query->stateOf(node).get()); });
    return query->search().run(
        [this, &ptc]
        {
            publishCounts();
            return ptc();
        });
}

std::shared_ptr<og::PathGeometric> PlannerSession::pathTo(NodeId node) const
{
    auto path = std::make_shared<og::PathGeometric>(si);
    for (const NodeId step : query->search().pathTo(node))
        path->append(query->stateOf(step).get());
    return path;
}

void PlannerSession::fillReport()
{
    const CheckStatistics& counts = query->broker().statistics();
    const NodeId goal = query->search().reachedGoal();
    report.cost =
        goal == lattice::kNoNode ? std::numeric_limits<double>::quiet_NaN() : query->search().costToCome(goal);
    report.expansions = query->search().expansions();
    report.orderHash = query->search().orderHash();
    report.nodes = query->lattice().size();
    report.checksUsed = counts.checksUsed;
    report.checksTotal = counts.checksRun;
    report.demandedChecks = counts.demandedChecks;
    report.speculativeChecks = counts.speculativeChecks;
    report.speculativeUsed = counts.speculativeUsed;
    report.speculativeDropped = counts.speculativeDropped;
    report.speculativeFailures = counts.failuresForgotten;
    report.usedReady = counts.usedReady;
    report.usedAfterWait = counts.usedAfterWait;
    report.usedInline = counts.usedInline;
    report.accuracy = counts.accuracy();
    report.coverage = counts.coverage();
    report.timeliness = counts.timeliness();
    report.threads = executor->workers();

    const bool simulated = settings.executor == "virtual";
    report.virtualTime = simulated ? clockInSearch : 0.0;
    report.waitTime = counts.waitSeconds;
    report.searchTime = simulated ? 0.0 : std::max(clockInSearch - counts.waitSeconds, 0.0);
    report.sequentialTime = counts.usedSeconds + report.searchTime;
    report.speedup = executor->runsInline() || !(clockInSearch > 0.0) ? 1.0 : report.sequentialTime / clockInSearch;
    report.efficiency = report.speedup / report.threads;
}

ob::PlannerStatus PlannerSession::publish(SearchStatus end, ob::Planner& planner)
{
    switch (end)
    {
        case SearchStatus::Solved:
            report.status = "solved";
            publishSolution(planner);
            return ob::PlannerStatus::EXACT_SOLUTION;
        case SearchStatus::Infeasible:
            report.status = "infeasible";
            OMPL_WARN("%s: no goal can be reached on this lattice; a finer resolution may find a way",
                      planner.getName().c_str());
            return kInfeasible;
        case SearchStatus::Stopped:
            break;
    }
    report.status = "timeout";
    return publishApproximation(planner) ? ob::PlannerStatus::APPROXIMATE_SOLUTION : ob::PlannerStatus::TIMEOUT;
}

void PlannerSession::publishSolution(ob::Planner& planner)
{
    const ob::ProblemDefinitionPtr& pdef = planner.getProblemDefinition();
    const NodeId goal = query->search().reachedGoal();
    const ob::Cost cost(query->search().costToCome(goal));
    live.bestCost.store(cost.value(), std::memory_order_relaxed);
    if (pdef->hasExactSolution() && published)
        return;  // an earlier call has done it, and the answer is the same
    published = true;
    const std::shared_ptr<og::PathGeometric> path = pathTo(goal);
    if (const auto& callback = pdef->getIntermediateSolutionCallback())
    {
        const std::vector<ob::State*>& states = path->getStates();
        callback(&planner, std::vector<const ob::State*>(states.begin(), states.end()), cost);
    }
    ob::PlannerSolution solution(path);
    solution.setPlannerName(planner.getName());
    if (const ob::OptimizationObjectivePtr& objective = pdef->getOptimizationObjective())
    {
        const ob::Cost itsCost = path->cost(objective);
        solution.setOptimized(objective, itsCost, objective->isSatisfied(itsCost));
    }
    pdef->addSolutionPath(solution);
}

bool PlannerSession::publishApproximation(ob::Planner& planner) const
{
    const LatticeQuery::Nearest nearest = query->nearestToGoal();
    if (nearest.node == lattice::kNoNode || query->search().parent(nearest.node) == lattice::kNoNode)
        return false;  // nothing is nearer than a start
    const std::shared_ptr<og::PathGeometric> path = pathTo(nearest.node);
    double difference = nearest.distance;
    planner.getProblemDefinition()->getGoal()->isSatisfied(path->getStates().back(), &difference);
    ob::PlannerSolution solution(path);
    solution.setPlannerName(planner.getName());
    solution.setApproximate(difference);
    planner.getProblemDefinition()->addSolutionPath(solution);
    return true;
}

ob::PlannerStatus PlannerSession::crash(const std::string& message, const std::string& name)
{
    OMPL_ERROR("%s: %s", name.c_str(), message.c_str());
    report.status = "crash";
    report.error = message;
    return ob::PlannerStatus::CRASH;
}
}  // namespace specplan::planner
