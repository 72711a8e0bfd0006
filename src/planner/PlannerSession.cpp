// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/PlannerSession.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <tuple>
#include <utility>

#include <ompl/base/goals/GoalRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "specplan/planner/Advice.h"
#include "specplan/planner/OmplCompat.h"
#include "specplan/util/Hash.h"

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
/// States taken from a goal region that can be sampled: at first and again whenever none of those can be reached, and
/// in all.
constexpr std::size_t kSampledGoals = 16;
constexpr std::size_t kMostSampledGoals = 1024;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// How often a goal that may get states is looked at while nothing else is to be done.
constexpr std::chrono::milliseconds kGoalPatience{1};

/// A goal's threshold below this means "this very state".
constexpr double kExact = 1e-9;

auto asTuple(const PlannerSettings& s)
{
    return std::tie(s.numThreads, s.speculationPolicy, s.predictor, s.lookahead, s.barrier, s.weight, s.anytime,
                    s.evaluation, s.resolution, s.spacing, s.connectivity, s.cornerCutting, s.objectiveInChecks,
                    s.executor, s.virtualCheckCost, s.stopAtFirstPath);
}

/// Whether states that were not sampled may satisfy the goal.
bool isRegion(const ob::Goal& goal)
{
    return !isMadeOfStates(goal) || goal.as<ob::GoalRegion>()->getThreshold() > kExact;
}
}  // namespace

void PlannerSession::prepare()
{
    if (!query)  // it would keep the executor that it was made with
        workers.prepare(settings);
}

void PlannerSession::reset()
{
    resetQuery();
    query.reset();
    if (TracingChecker* tracer = workers.tracer())
        tracer->clearNotes();
}

void PlannerSession::resetQuery()
{
    if (query)
        query->beginQuery();
    dataStates.clear();
    report = {};
    bound_ = kUnknown;
    finished_ = false;
    best_.reset();
    proof_.reset();
    history_.clear();
    past_ = {};
    clockInSearch_ = 0.0;
    live.expansions = 0;
    live.checksUsed = 0;
    live.speculativeChecks = 0;
    live.bestCost = std::numeric_limits<double>::infinity();
    inputs_.close();
    inputsChanged_ = false;
}

PlannerSession::PlannerSession(ob::SpaceInformationPtr spaceInformation)
    : si(std::move(spaceInformation)), workers(si), inputs_(*si)
{
}

void PlannerSession::takeStarts(const ob::ProblemDefinition& pdef, const ob::PlannerTerminationCondition& ptc)
{
    while (const ob::State* start = inputs_.nextStart(ptc))
    {
        if (!query)
        {
            ob::OptimizationObjectivePtr objective = pdef.getOptimizationObjective();
            if (!objective)
                objective = std::make_shared<ob::PathLengthOptimizationObjective>(si);
            query =
                std::make_unique<LatticeQuery>(*si, std::move(objective), settings, hooks, workers.executor(),
                                               workers.checker(), workers.makeSources(), start, looksForBetter(pdef));
            refinements_ = 0;
        }
        const bool isFirst = query->starts().empty();
        query->addStart(start);
        if (isFirst)
            requireWholeStates();
        inputsChanged_ = true;
    }
}

/// The next call begins anew where the states that the planner writes are not whole.
void PlannerSession::requireWholeStates()
{
    try
    {
        query->requireWholeStates();
    }
    catch (...)
    {
        query.reset();
        throw;
    }
}

/// Takes the goal states that can be had now: all, or as many samples of a region as are wanted so far.
/// \return whether there was a valid one.
bool PlannerSession::takeGoals(const ob::Goal& goal, const ob::PlannerTerminationCondition& ptc)
{
    bool added = false;
    while (goalsCameUp(goal))
    {
        const ob::State* state = inputs_.nextGoal(ptc);
        if (state == nullptr)
            break;
        query->addGoal(state);
        added = true;
    }
    return added;
}

/// Takes goal states as soon as they come up. \return false if there are none until `ptc` says stop, or none can come.
bool PlannerSession::waitForGoals(const ob::Goal& goal, const ob::PlannerTerminationCondition& ptc)
{
    while (!takeGoals(goal, ptc))
    {
        if (ptc())
            return false;
        if (inputs_.hasGoal() && sampleLimit_ < kMostSampledGoals)
            sampleLimit_ += kSampledGoals;
        else if (inputs_.mayGetGoals())
            std::this_thread::sleep_for(kGoalPatience);
        else
            return false;
    }
    return true;
}

/// Whether a goal has come up that the search does not know of yet.
bool PlannerSession::goalsCameUp(const ob::Goal& goal) const
{
    const std::size_t limit = isMadeOfStates(goal)  ? std::numeric_limits<std::size_t>::max()
                              : inputs_.isGrowing() ? kMostSampledGoals
                                                    : sampleLimit_;
    return inputs_.goalsSeen() < limit && inputs_.hasGoal();
}

std::optional<ob::PlannerStatus> PlannerSession::refuse(ob::PlannerStatus::StatusType status, const char* name)
{
    report.status = name;
    return ob::PlannerStatus(status);
}

std::optional<ob::PlannerStatus> PlannerSession::openQuery(const ob::ProblemDefinitionPtr& pdef,
                                                           const ob::PlannerTerminationCondition& ptc, bool waits)
{
    const bool wasTorn = std::exchange(isTorn_, true);
    const Origins now(*si, *pdef);
    if (wasTorn || (query && (sourcesChanged || !origins.same(now) || asTuple(querySettings) != asTuple(settings))))
        reset();
    else if (searchFailed_ || !inputs_.continues(pdef) || (best_ && !best_.leadsTo(*pdef->getGoal())))
        resetQuery();
    origins = now;
    querySettings = settings;
    sourcesChanged = false;
    searchFailed_ = false;
    workers.prepare(settings);
    if (!query || !inputs_.continues(pdef))  // without a query an earlier call took starts and failed
    {
        inputs_.open(pdef);
        sampleLimit_ = kSampledGoals;
    }

    const auto refused = openInputs(*pdef, ptc, waits);
    isTorn_ = false;
    return refused;
}

std::optional<ob::PlannerStatus> PlannerSession::openInputs(const ob::ProblemDefinition& pdef,
                                                            const ob::PlannerTerminationCondition& ptc, bool waits)
{
    takeStarts(pdef, ptc);
    if (inputs_.hasStart() && (!query || query->starts().empty()))
        return refuse(ob::PlannerStatus::TIMEOUT, "timeout");
    if (!query || query->starts().empty())
    {
        OMPL_ERROR("SpeculativeAStar: there is no valid start state");
        return refuse(ob::PlannerStatus::INVALID_START, "invalid start");
    }
    const ob::GoalPtr& goal = pdef.getGoal();
    if (inputsChanged_)
        query->setGoal(goal, isRegion(*goal));
    const bool added = waits && query->goals().empty() ? waitForGoals(*goal, ptc) : takeGoals(*goal, ptc);
    inputsChanged_ = inputsChanged_ || added;
    if (query->goals().empty() && !isRegion(*goal))
    {
        if (inputs_.hasGoal())
            return refuse(ob::PlannerStatus::TIMEOUT, "timeout");
        OMPL_ERROR("SpeculativeAStar: there is no valid goal state");
        return refuse(ob::PlannerStatus::INVALID_GOAL, "invalid goal");
    }
    if (inputsChanged_)
        beginFirstSearch(pdef);
    inputsChanged_ = false;
    return std::nullopt;
}

void PlannerSession::beginFirstSearch(const ob::ProblemDefinition& pdef)
{
    if (query->embedding().isCoarse())
        (void)query->refine();
    Schedule::Terms terms;
    terms.weight = query->firstWeight(looksForBetter(pdef)              ? LatticeQuery::Wish::BetterPaths
                                      : pdef.hasOptimizationObjective() ? LatticeQuery::Wish::BestPath
                                                                        : LatticeQuery::Wish::AnyPath);
    terms.automatic = !(settings.weight > 0.0);
    terms.weighted = query->addsCosts();
    terms.coarsens = query->embedding().canCoarsen();
    terms.axes = query->embedding().axes();
    schedule_ = Schedule(terms);
    if (schedule_.isCoarse())
        query->coarsen();
    finished_ = false;
    best_.reset();
    proof_.reset();
    past_ = {};
    patienceEnds_ = schedule_.current().patience;
    history_.clear();
    history_.begin(query->embedding().level(), schedule_.current().weight, query->embedding().nodes(),
                   query->broker().statistics().checksUsed);
    query->beginSearch(schedule_.current().weight);
}

/// \return false if the lattice cannot become any finer.
bool PlannerSession::beginNextSearch(Schedule::End end)
{
    isTorn_ = true;
    const Past past{expansions(), orderHash()};
    const bool wasCoarse = schedule_.isCoarse();
    const Schedule::Search& next = schedule_.next(end);
    if (next.change == Schedule::Change::Coarsen)
        query->coarsen();
    else if (next.change == Schedule::Change::Refine)
    {
        if (!query->refine())
        {
            isTorn_ = false;
            return false;
        }
        refinements_ += wasCoarse ? 0 : 1;
    }
    past_ = past;
    patienceEnds_ = next.patience == Schedule::kEndless ? Schedule::kEndless : verdictsUsed() + next.patience;
    history_.begin(query->embedding().level(), next.weight, query->embedding().nodes(),
                   query->broker().statistics().checksUsed);
    query->beginSearch(next.weight);
    isTorn_ = false;
    return true;
}

std::uint64_t PlannerSession::expansions() const
{
    return past_.expansions + (query && query->isSearching() ? query->search().steps() : 0);
}

std::uint64_t PlannerSession::orderHash() const
{
    const std::uint64_t now = query && query->isSearching() ? query->search().orderHash() : 0;
    return past_.orderHash == 0 ? now : util::mix(past_.orderHash, now);
}

void PlannerSession::publishCounts()
{
    // Relaxed: each counter stands for itself.
    const CheckStatistics& counts = query->broker().statistics();
    live.expansions.store(expansions(), std::memory_order_relaxed);
    live.checksUsed.store(counts.checksUsed, std::memory_order_relaxed);
    live.speculativeChecks.store(counts.speculativeChecks, std::memory_order_relaxed);
}

SearchStatus PlannerSession::search(const ob::Goal& goal, const ob::PlannerTerminationCondition& ptc)
{
    /// Nothing may run any more when solve() is left, whichever way.
    struct Settle
    {
        PlannerSession& session;
        double clock = session.workers.executor().now();

        ~Settle()
        {
            session.clockInSearch_ += session.workers.executor().now() - clock;
            session.query->broker().settle();
            session.query->broker().setInterrupt({});
            session.query->setObserver({});
            session.publishCounts();
        }
    };
    const Settle settle{*this};
    query->broker().setInterrupt([&ptc] { return ptc(); });
    if (observer)
        query->setObserver([this](NodeId node) { observer(query->stateOf(node).get()); });
    for (;;)
    {
        bool goalCameUp = false;
        searchFailed_ = true;
        const SearchStatus end = query->search().run(
            [&]
            {
                publishCounts();
                goalCameUp = goalsCameUp(goal);
                searchFailed_ = false;  // between two expansions nothing is half done
                const bool stops = goalCameUp || isOutOfPatience() || query->broker().isInterrupted();
                searchFailed_ = true;
                return stops;
            });
        searchFailed_ = false;
        const bool exhausted = end == SearchStatus::Infeasible;
        if (!exhausted && !(end == SearchStatus::Stopped && goalCameUp))
            return end;
        query->broker().settle();  // taking goals checks them in this thread
        isTorn_ = true;
        const bool added = exhausted ? waitForGoals(goal, ptc) : takeGoals(goal, ptc);
        if (added)
            query->goalsChanged();
        isTorn_ = false;
        if (!added && !exhausted && ptc())
            return SearchStatus::Stopped;  // what has come up is left for the next call
        if (!added && exhausted)
            return ptc() && (inputs_.hasGoal() || inputs_.mayGetGoals()) ? SearchStatus::Stopped : end;
    }
}

/// Whether a first path is not the end.
bool PlannerSession::looksForBetter(const ob::ProblemDefinition& pdef) const
{
    return settings.anytime && !settings.stopAtFirstPath && pdef.hasOptimizationObjective();
}

/// Whether something better than what is known is looked for.
bool PlannerSession::wantsBetter(const ob::ProblemDefinition& pdef) const
{
    return looksForBetter(pdef) && !pdef.getOptimizationObjective()->isSatisfied(best_.cost());
}

std::uint64_t PlannerSession::verdictsUsed() const
{
    const CheckStatistics& counts = query->broker().statistics();
    return counts.checksUsed + counts.checksReused;
}

/// Whether the search has gone on for long enough.
bool PlannerSession::isOutOfPatience() const
{
    return verdictsUsed() >= patienceEnds_;
}

ob::PlannerStatus PlannerSession::solve(const ob::PlannerTerminationCondition& ptc, ob::Planner& planner)
{
    const ob::ProblemDefinition& pdef = *planner.getProblemDefinition();
    while (!finished_)
    {
        const SearchStatus end = proof_ ? SearchStatus::Solved : search(*pdef.getGoal(), ptc);
        noteEnd(end);
        if (end == SearchStatus::Stopped && !isOutOfPatience())
            break;
        if (end == SearchStatus::Solved)
        {
            if (!takeSolution(planner, ptc))
                break;
            finished_ = !wantsBetter(pdef) || !beginNextSearch(Schedule::End::Solved);
        }
        else if (end == SearchStatus::Stopped)
            (void)beginNextSearch(Schedule::End::GivenUp);
        else if (schedule_.isCoarse())
            (void)beginNextSearch(Schedule::End::Infeasible);
        else if (!best_ && settings.anytime && query->embedding().coarseness() > 1.0 &&
                 beginNextSearch(Schedule::End::Infeasible))
        {
            OMPL_INFORM("%s: no goal can be reached on the lattice; going on with half its spacing",
                        planner.getName().c_str());
        }
        else if (best_)
        {
            finished_ = true;  // other goals cannot be reached
        }
        else
        {
            report.status = "infeasible";
            OMPL_WARN("%s: no goal can be reached on this lattice", planner.getName().c_str());
            tellWhatToTry(planner.getName());
            return kInfeasible;
        }
    }
    if (best_)
    {
        report.status = "solved";
        best_.publish(planner);
        return ob::PlannerStatus::EXACT_SOLUTION;
    }
    report.status = "timeout";
    const bool approximate = publishApproximation(planner);
    tellWhatToTry(planner.getName());
    return approximate ? ob::PlannerStatus::APPROXIMATE_SOLUTION : ob::PlannerStatus::TIMEOUT;
}

void PlannerSession::noteEnd(SearchStatus end)
{
    const char* name = end == SearchStatus::Solved       ? "solved"
                       : end == SearchStatus::Infeasible ? "no path"
                       : isOutOfPatience()               ? "given up"
                                                         : "stopped";
    history_.note(name, query->search().steps(), query->broker().statistics().checksUsed);
}

/// Says how far each search has come, and what may help. The report keeps both.
void PlannerSession::tellWhatToTry(const std::string& name)
{
    fillReport();
    for (const LatticeSearchReport& search : report.searches)
        OMPL_INFORM("%s: %s", name.c_str(), describe(search).c_str());
    if (report.status == "timeout" && std::isfinite(report.distanceToGoal))
        OMPL_INFORM("%s: the nearest state is %g from the goal", name.c_str(), report.distanceToGoal);
    report.advice = advise(report, settings, query->canBeLazy(), workers.processors());
    OMPL_INFORM("%s: %s", name.c_str(), report.advice.c_str());
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
    report.cost = best_ ? best_.cost().value() : kUnknown;
    report.evaluation = query->isLazy() ? "lazy" : "eager";
    report.weight = weight();
    report.bound = bound_;
    report.refinements = refinements_;
    report.expansions = expansions();
    report.orderHash = orderHash();
    report.nodes = query->lattice().size();
    report.checksUsed = counts.checksUsed;
    report.checksReused = counts.checksReused;
    report.checksTotal = counts.checksRun + inputs_.checksRun();
    report.demandedChecks = counts.demandedChecks + inputs_.checksRun();
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
    report.threads = workers.executor().workers();
    report.searches = history_.searches();

    const bool simulated = settings.executor == "virtual";
    report.virtualTime = simulated ? clockInSearch_ : 0.0;
    report.waitTime = counts.waitSeconds;
    report.searchTime =
        simulated && workers.tracer() == nullptr ? 0.0 : std::max(clockInSearch_ - counts.waitSeconds, 0.0);
    report.sequentialTime = counts.usedSeconds + report.searchTime;
    report.speedup =
        workers.executor().runsInline() || !(clockInSearch_ > 0.0) ? 1.0 : report.sequentialTime / clockInSearch_;
    report.efficiency = report.speedup / report.threads;
}

/// Keeps the path just found if it is the best one so far. \return false if it was told to stop before.
bool PlannerSession::takeSolution(ob::Planner& planner, const ob::PlannerTerminationCondition& ptc)
{
    const NodeId goal = query->search().reachedGoal();
    const ob::Cost cost = query->costToCome(goal);
    bound_ = schedule_.isCoarse() ? kUnknown : weight();
    if (best_ && !query->isBetter(cost, best_.cost()))
        return true;
    const bool needsProof = !query->embedding().writesWholeStates();
    if (needsProof && !prove(goal, ptc))
        return false;
    live.bestCost.store(cost.value(), std::memory_order_relaxed);
    best_.take(needsProof ? proof_->path() : pathTo(goal), cost, planner);
    proof_.reset();
    return true;
}

/// \return false if it was told to stop before the end; the next call goes on.
/// \throws ompl::Exception if the path is not valid.
bool PlannerSession::prove(NodeId goal, const ob::PlannerTerminationCondition& ptc)
{
    if (!proof_)
        proof_.emplace(*si, pathTo(goal));
    const std::uint64_t before = proof_->checks();
    const bool complete = proof_->run([&ptc] { return ptc(); });
    report.pathChecks += proof_->checks() - before;
    if (!proof_->fault().empty())
        throw ompl::Exception(proof_->fault());
    return complete;
}

bool PlannerSession::publishApproximation(ob::Planner& planner)
{
    const LatticeQuery::Nearest nearest = query->nearestToGoal();
    report.distanceToGoal = nearest.node == lattice::kNoNode ? kUnknown : nearest.distance;
    if (nearest.node == lattice::kNoNode || query->search().parent(nearest.node) == lattice::kNoNode)
        return false;  // nothing is nearer than a start
    const std::shared_ptr<og::PathGeometric> path = pathTo(nearest.node);
    double difference = nearest.distance;
    const StateHandle end(*si, path->getStates().back());  // the user's goal may write into it
    planner.getProblemDefinition()->getGoal()->isSatisfied(end.get(), &difference);
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
