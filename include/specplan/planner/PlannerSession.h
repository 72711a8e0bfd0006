// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include "specplan/planner/LatticeQuery.h"
#include "specplan/planner/OmplChecker.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/validity/Executor.h"

namespace specplan::planner
{
/// Which objects a query was built for. Weak, so that a planner keeps no checker alive; the control block stays, so a
/// new object at the old address is told apart.
struct Origins
{
    std::weak_ptr<const void> checker;
    std::weak_ptr<const void> motionValidator;
    std::weak_ptr<const void> objective;
    std::vector<double> bounds;
    double segment = 0.0;

    [[nodiscard]] bool same(const Origins& other) const
    {
        const auto equal = [](const std::weak_ptr<const void>& a, const std::weak_ptr<const void>& b)
        { return !a.owner_before(b) && !b.owner_before(a); };
        return equal(checker, other.checker) && equal(motionValidator, other.motionValidator) &&
               equal(objective, other.objective) && bounds == other.bounds && segment == other.segment;
    }
};

/// What the planner keeps between calls. The search thread owns all of it but `live`.
class PlannerSession
{
public:
    /// Counters that OMPL's Benchmark reads from a thread of its own while solve() runs.
    struct Live
    {
        std::atomic<std::uint64_t> expansions{0};
        std::atomic<std::uint64_t> checksUsed{0};
        std::atomic<std::uint64_t> speculativeChecks{0};
        std::atomic<double> bestCost{std::numeric_limits<double>::infinity()};
    };

    explicit PlannerSession(ompl::base::SpaceInformationPtr spaceInformation) : si(std::move(spaceInformation))
    {
    }

    void reset();
    void ensureExecutor();
    [[nodiscard]] Origins currentOrigins(const ompl::base::ProblemDefinition& pdef) const;
    [[nodiscard]] OmplChecker::Sources makeSources() const;
    [[nodiscard]] std::optional<ompl::base::PlannerStatus> openQuery(
        ompl::base::PlannerInputStates& inputs, const ompl::base::ProblemDefinition& pdef,
        const ompl::base::PlannerTerminationCondition& ptc);
    bool takeStarts(ompl::base::PlannerInputStates& inputs, const ompl::base::ProblemDefinition& pdef);
    bool takeGoals(ompl::base::PlannerInputStates& inputs, const ompl::base::Goal& goal,
                   const ompl::base::PlannerTerminationCondition& ptc);
    void publishCounts();
    [[nodiscard]] search::SearchStatus search(const ompl::base::PlannerTerminationCondition& ptc);
    [[nodiscard]] std::shared_ptr<ompl::geometric::PathGeometric> pathTo(lattice::NodeId node) const;
    void fillReport();
    /// Tells OMPL how the search ended: solution path, intermediate callback, status.
    [[nodiscard]] ompl::base::PlannerStatus publish(search::SearchStatus end, ompl::base::Planner& planner);
    void publishSolution(ompl::base::Planner& planner);
    [[nodiscard]] bool publishApproximation(ompl::base::Planner& planner) const;
    [[nodiscard]] ompl::base::PlannerStatus crash(const std::string& message, const std::string& name);

    const ompl::base::SpaceInformationPtr si;
    PlannerSettings settings;
    SpeculativeAStar::StateValidityCheckerAllocator checkerAllocator;
    SpeculativeAStar::MotionValidatorAllocator motionValidatorAllocator;
    std::function<void(const ompl::base::State*)> observer;

    // Order matters: the executor's threads end before the checker they use.
    std::unique_ptr<OmplChecker> checker;
    std::unique_ptr<validity::Executor> executor;
    PlannerSettings executorSettings;
    std::unique_ptr<LatticeQuery> query;
    PlannerSettings querySettings;
    Origins origins;
    bool sourcesChanged = false;  ///< an allocator was set since the query was opened

    mutable std::unordered_map<lattice::NodeId, StateHandle> dataStates;  ///< states handed out by getPlannerData
    SearchReport report;
    bool published = false;      ///< the solution has been given to OMPL
    double clockInSearch = 0.0;  ///< seconds on the executor's clock spent in run()
    Live live;
};
}  // namespace specplan::planner
