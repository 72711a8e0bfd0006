// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/SpeculativeAStar.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include <ompl/base/PlannerData.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "spaces/DescribedAxes.h"
#include "specplan/planner/Explanation.h"
#include "specplan/planner/PlannerParameters.h"
#include "specplan/planner/PlannerSession.h"
#include "specplan/validity/BudgetShare.h"
#include "specplan/validity/RunCheck.h"

namespace specplan
{
namespace ob = ompl::base;

SpeculativeAStar::SpeculativeAStar(const ob::SpaceInformationPtr& si) : SpeculativeAStar(si, PlannerSettings())
{
}

SpeculativeAStar::SpeculativeAStar(const ob::SpaceInformationPtr& si, const PlannerSettings& settings)
    : ob::Planner(si, "SpeculativeAStar"), session_(std::make_unique<planner::PlannerSession>(si))
{
    specs_.recognizedGoal = ob::GOAL_ANY;
    specs_.multithreaded = true;
    specs_.approximateSolutions = true;
    specs_.optimizingPaths = true;
    specs_.directed = true;
    specs_.provingSolutionNonExistence = true;
    specs_.canReportIntermediateSolutions = true;
    setSettings(settings);
    planner::declareParameters(
        params_, [this] { return session_->settings; },
        [this](const PlannerSettings& changed) { setSettings(changed); });

    const auto count = [](const std::atomic<std::uint64_t>& counter)
    { return [&counter] { return std::to_string(counter.load(std::memory_order_relaxed)); }; };
    addPlannerProgressProperty("expansions INTEGER", count(session_->live.expansions));
    addPlannerProgressProperty("checks used INTEGER", count(session_->live.checksUsed));
    addPlannerProgressProperty("speculative checks INTEGER", count(session_->live.speculativeChecks));
    addPlannerProgressProperty("best cost REAL", [this] { return std::to_string(session_->live.bestCost.load()); });
}

SpeculativeAStar::~SpeculativeAStar() = default;

void SpeculativeAStar::checkValidity()
{
    ob::Planner::checkValidity();
    try
    {
        requireLattice();
    }
    catch (const ompl::Exception& error)
    {
        throw ompl::Exception(getName() + ": " + error.what());
    }
}

void SpeculativeAStar::requireLattice() const
{
    for (const planner::Part& part : planner::decompose(si_->getStateSpace(), session_->hooks).parts)
        if (const auto* real = dynamic_cast<const ob::RealVectorStateSpace*>(part.space.get()))
            real->getBounds().check();
}

void SpeculativeAStar::setup()
{
    ob::Planner::setup();
    session_->prepare();
    if (pdef_)
        warnOfSettings();
}

/// Tells of settings that do not fit the space before a search does.
void SpeculativeAStar::warnOfSettings() const
{
    if (pdef_->getStartStateCount() == 0 || !planner::oddValue(*si_->getStateSpace(), pdef_->getStartState(0)).empty())
        return;
    try
    {
        const planner::Embedding embedding(*si_, session_->settings, session_->hooks, pdef_->getStartState(0));
    }
    catch (const std::exception& error)
    {
        OMPL_WARN("%s: solve() will fail: %s", getName().c_str(), error.what());
    }
}

void SpeculativeAStar::clear()
{
    ob::Planner::clear();
    session_->reset();
}

void SpeculativeAStar::clearQuery()
{
    pis_.clear();
    pis_.update();
    session_->resetQuery();
}

ob::PlannerStatus SpeculativeAStar::solve(const ob::PlannerTerminationCondition& ptc)
{
    ob::Planner::checkValidity();
    const double start = validity::steadySeconds();
    const validity::BudgetSeat seat(session_->workers.openShare());
    ob::PlannerStatus status;
    std::exception_ptr failure;
    session_->report.error.clear();
    session_->report.advice.clear();
    try
    {
        requireLattice();  // not an exception: OMPL's ParallelPlan would end the program
        const auto refused = session_->openQuery(pdef_, ptc, true);
        status = refused ? *refused : session_->solve(ptc, *this);
    }
    catch (const std::exception& error)
    {
        failure = std::current_exception();
        status = session_->crash(error.what(), getName());
    }
    catch (...)
    {
        failure = std::current_exception();
        status = session_->crash("a check threw something that is not a std::exception", getName());
    }
    session_->report.wallTime += validity::steadySeconds() - start;
    if (session_->query && session_->query->isSearching())
        session_->fillReport();
    if (planner::TracingChecker* tracer = session_->workers.tracer())
        tracer->absorb();
    if (failure && session_->settings.rethrowExceptions)
        std::rethrow_exception(failure);
    return status;
}

void SpeculativeAStar::getPlannerData(ob::PlannerData& data) const
{
    ob::Planner::getPlannerData(data);
    if (!session_->query || !session_->query->isSearching())
        return;
    planner::describeRun(session_->report, data.properties);
    const planner::LatticeQuery& query = *session_->query;
    const auto vertex = [this, &query](lattice::NodeId node)
    {
        auto found = session_->dataStates.find(node);
        if (found == session_->dataStates.end())
            found = session_->dataStates.emplace(node, query.stateOf(node)).first;
        return ob::PlannerDataVertex(found->second.get());
    };
    for (const lattice::NodeId start : query.starts())
        data.addStartVertex(vertex(start));
    for (const lattice::NodeId goal : query.goals())
        data.addGoalVertex(vertex(goal));
    for (lattice::NodeId node = 0; node < query.lattice().size(); ++node)
    {
        const lattice::NodeId parent = query.search().parent(node);
        if (parent != lattice::kNoNode)
            data.addEdge(vertex(parent), vertex(node), ob::PlannerDataEdge(), query.costOfMotionTo(node));
    }
}

const PlannerSettings& SpeculativeAStar::getSettings() const
{
    return session_->settings;
}

void SpeculativeAStar::setSettings(const PlannerSettings& settings)
{
    planner::validate(settings);
    session_->settings = settings;
}

void SpeculativeAStar::setStateValidityCheckerAllocator(StateValidityCheckerAllocator allocator)
{
    session_->workers.checkerAllocator = std::move(allocator);
    session_->sourcesChanged = true;
}

void SpeculativeAStar::setMotionValidatorAllocator(MotionValidatorAllocator allocator)
{
    session_->workers.motionValidatorAllocator = std::move(allocator);
    session_->sourcesChanged = true;
}

void SpeculativeAStar::setStateCompleter(std::function<void(ob::State*)> complete)
{
    session_->hooks.complete = std::move(complete);
    session_->sourcesChanged = true;
}

void SpeculativeAStar::setLatticeAxes(const LatticeAxes& axes)
{
    planner::validate(axes);
    std::vector<LatticeAxes>& described = session_->hooks.described;
    described.erase(std::remove_if(described.begin(), described.end(),
                                   [&axes](const LatticeAxes& other) { return other.space == axes.space; }),
                    described.end());
    if (!axes.axes.empty())
        described.push_back(axes);
    session_->sourcesChanged = true;
}

void SpeculativeAStar::setThreadBudget(std::shared_ptr<ThreadBudget> budget)
{
    session_->workers.budget = std::move(budget);
    session_->sourcesChanged = true;
}

void SpeculativeAStar::forgetVerdicts()
{
    session_->reset();
}

void SpeculativeAStar::explain(std::ostream& out)
{
    if (!pdef_)
        throw ompl::Exception(getName() +
                              ": explain() needs start and goal: call it after setProblemDefinition(), "
                              "or after SimpleSetup::setup()");
    checkValidity();
    const auto refused = session_->openQuery(pdef_, ob::plannerNonTerminatingCondition(), false);
    planner::explain(*session_, refused ? refused->asString() : "", out);
}

const SearchReport& SpeculativeAStar::getReport() const
{
    return session_->report;
}

void SpeculativeAStar::visitStates(const std::function<void(const ob::State*, StateFate)>& visit) const
{
    if (!session_->query || !session_->query->isSearching())
        return;
    const planner::LatticeQuery& query = *session_->query;
    for (lattice::NodeId node = 0; node < query.lattice().size(); ++node)
    {
        const validity::Verdict verdict = query.broker().verdict(validity::CheckId::ofState(node));
        std::optional<StateFate> fate;
        if (verdict == validity::Verdict::Invalid)
            fate =
                query.broker().isUsed(validity::CheckId::ofState(node)) ? StateFate::Invalid : StateFate::CheckedUnused;
        else if (query.search().isExpanded(node))
            fate = StateFate::Expanded;
        else if (query.search().isReached(node))
            fate = StateFate::Open;
        else if (validity::isKnown(verdict))
            fate = StateFate::CheckedUnused;
        if (fate)
            visit(query.stateOf(node).get(), *fate);
    }
}

void SpeculativeAStar::setCheckTrace(std::shared_ptr<planner::CheckTrace> trace)
{
    session_->workers.trace = std::move(trace);
    session_->sourcesChanged = true;
}

void SpeculativeAStar::visitChecks(const std::function<void(const CheckRun&)>& visit) const
{
    if (!session_->query || session_->workers.tracer() == nullptr)
        return;
    const planner::LatticeQuery& query = *session_->query;
    const std::vector<planner::TracingChecker::Note> notes = session_->workers.tracer()->notes();
    for (const planner::TracingChecker::Note& note : notes)
    {
        CheckRun run{nullptr,
                     nullptr,
                     note.valid,
                     query.broker().isUsed(note.check),
                     note.start - notes.front().start,
                     note.seconds,
                     note.worker,
                     note.check.isMotion() && query.lattice().isGlance(note.check.motion())};
        const bool motion = note.check.isMotion();
        const lattice::Lattice::Motion ends =
            motion ? query.lattice().motion(note.check.motion()) : lattice::Lattice::Motion{note.check.node(), 0};
        const planner::StateHandle from = query.stateOf(ends.from);
        const std::optional<planner::StateHandle> to =
            motion ? std::make_optional(query.stateOf(ends.to)) : std::nullopt;
        run.from = from.get();
        run.to = motion ? to->get() : nullptr;
        visit(run);
    }
}

void SpeculativeAStar::setExpansionObserver(std::function<void(const ob::State*)> observer)
{
    session_->observer = std::move(observer);
}
}  // namespace specplan
