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

#include "specplan/planner/BestPath.h"
#include "specplan/planner/LatticeQuery.h"
#include "specplan/planner/Origins.h"
#include "specplan/planner/PathProof.h"
#include "specplan/planner/QueryInputs.h"
#include "specplan/planner/Schedule.h"
#include "specplan/planner/SearchHistory.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/planner/Workers.h"

namespace specplan::planner
{
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

    explicit PlannerSession(ompl::base::SpaceInformationPtr spaceInformation);

    /// Starts threads ahead of the first search.
    void prepare();

    /// Forgets everything but the settings.
    void reset();

    /// Forgets starts, goals and solutions; verdicts stay as long as checker and space stay.
    void resetQuery();

    /// Makes lattice, starts and goals ready for a search.
    /// \return a status if there is nothing to search.
    /// \param waits whether to wait for a first goal state, as long as one may come up.
    [[nodiscard]] std::optional<ompl::base::PlannerStatus> openQuery(const ompl::base::ProblemDefinitionPtr& pdef,
                                                                     const ompl::base::PlannerTerminationCondition& ptc,
                                                                     bool waits);

    /// Searches, and goes on with smaller weights and finer lattices where that is wanted; tells OMPL what it finds.
    [[nodiscard]] ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc,
                                                  ompl::base::Planner& planner);

    void fillReport();
    [[nodiscard]] ompl::base::PlannerStatus crash(const std::string& message, const std::string& name);

    const ompl::base::SpaceInformationPtr si;
    PlannerSettings settings;
    SpaceHooks hooks;  ///< a change has to drop the query
    std::function<void(const ompl::base::State*)> observer;
    Workers workers;  ///< before the query, which uses them to its end
    std::unique_ptr<LatticeQuery> query;
    PlannerSettings querySettings;
    Origins origins;
    bool sourcesChanged = false;  ///< an allocator was set since the query was opened

    mutable std::unordered_map<lattice::NodeId, StateHandle> dataStates;  ///< states handed out by getPlannerData
    SearchReport report;
    Live live;

    /// Weight of the search that is on.
    [[nodiscard]] double weight() const noexcept
    {
        return schedule_.current().weight;
    }

private:
    /// The searches of a query before the current one.
    struct Past
    {
        std::uint64_t expansions = 0;
        std::uint64_t orderHash = 0;
    };

    void requireWholeStates();
    void takeStarts(const ompl::base::ProblemDefinition& pdef, const ompl::base::PlannerTerminationCondition& ptc);
    [[nodiscard]] bool takeGoals(const ompl::base::Goal& goal, const ompl::base::PlannerTerminationCondition& ptc);
    [[nodiscard]] bool waitForGoals(const ompl::base::Goal& goal, const ompl::base::PlannerTerminationCondition& ptc);
    [[nodiscard]] bool goalsCameUp(const ompl::base::Goal& goal) const;
    [[nodiscard]] std::optional<ompl::base::PlannerStatus> openInputs(
        const ompl::base::ProblemDefinition& pdef, const ompl::base::PlannerTerminationCondition& ptc, bool waits);
    [[nodiscard]] std::optional<ompl::base::PlannerStatus> refuse(ompl::base::PlannerStatus::StatusType status,
                                                                  const char* name);
    void publishCounts();
    [[nodiscard]] search::SearchStatus search(const ompl::base::Goal& goal,
                                              const ompl::base::PlannerTerminationCondition& ptc);
    void beginFirstSearch(const ompl::base::ProblemDefinition& pdef);
    [[nodiscard]] bool beginNextSearch(Schedule::End end);
    [[nodiscard]] bool looksForBetter(const ompl::base::ProblemDefinition& pdef) const;
    [[nodiscard]] bool wantsBetter(const ompl::base::ProblemDefinition& pdef) const;
    [[nodiscard]] std::uint64_t verdictsUsed() const;
    [[nodiscard]] bool isOutOfPatience() const;
    [[nodiscard]] std::shared_ptr<ompl::geometric::PathGeometric> pathTo(lattice::NodeId node) const;
    [[nodiscard]] bool takeSolution(ompl::base::Planner& planner, const ompl::base::PlannerTerminationCondition& ptc);
    [[nodiscard]] bool prove(lattice::NodeId goal, const ompl::base::PlannerTerminationCondition& ptc);
    [[nodiscard]] bool publishApproximation(ompl::base::Planner& planner);
    void noteEnd(search::SearchStatus end);
    void tellWhatToTry(const std::string& name);
    [[nodiscard]] std::uint64_t expansions() const;
    [[nodiscard]] std::uint64_t orderHash() const;

    QueryInputs inputs_;
    bool inputsChanged_ = false;   ///< starts or goals have come that the search was not begun with
    std::size_t sampleLimit_ = 0;  ///< samples to be taken from a goal region so far
    Schedule schedule_;
    SearchHistory history_;
    double bound_ = std::numeric_limits<double>::quiet_NaN();
    unsigned refinements_ = 0;
    std::uint64_t patienceEnds_ = Schedule::kEndless;  ///< verdicts used when the search is given up
    bool searchFailed_ = false;  ///< an exception came in the middle of an expansion: search anew, verdicts stay
    bool isTorn_ = false;        ///< an exception came while starts, goals or the lattice were changing: begin anew
    bool finished_ = false;      ///< nothing is left to be improved
    BestPath best_;
    std::optional<PathProof> proof_;  ///< of the path just found, if it needs one
    Past past_;
    double clockInSearch_ = 0.0;  ///< seconds on the executor's clock spent in run()
};
}  // namespace specplan::planner
