// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <mutex>
#include <unordered_set>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "specplan/planner/Embedding.h"
#include "specplan/planner/ObjectiveCosts.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/validity/Checker.h"
#include "specplan/validity/StopSignal.h"

namespace specplan::planner
{
/// Answers checks through OMPL's state validity checkers and motion validators.
///
/// OMPL's DiscreteMotionValidator, and those for Dubins and Reeds-Shepp cars, count their calls in plain integers,
/// which is a data race when two threads use them. They are replaced by the same test: the inner states of
/// Embedding::segments(). Any other motion validator is called as it is: each worker's own if there is one, otherwise
/// the shared one by one thread at a time. A motion that is valid also gets its cost, where an objective tells it; by
/// one thread at a time, too, where each worker has a checker of its own and the objective may ask the shared one.
///
/// Between the states of a motion the stop signal is looked at, and the check broken off if it says so. A motion
/// validator of another class cannot be stopped inside.
///
/// No state is checked twice for one motion: not where states in between are rounded to those beside them or to the
/// ends, and not those again that a glance has found to be valid.
///
/// A fresh state is made for each check: no two threads hold the same one, and checkers that keep notes in a state (as
/// MoveIt's does) never find an old one.
///
/// Threads: `open` by the search thread while nothing runs; `check` by workers, each with its own number.
class OmplChecker : public validity::Checker
{
public:
    /// A glance at a motion looks at so many of its inner states: the middle, the quarters, the eighths. (Of a motion
    /// that leaves the bounds between two of these it may look at fewer.)
    static constexpr std::uint32_t kGlanceStates = 7;

    /// What to check with.
    struct Sources
    {
        std::vector<ompl::base::StateValidityCheckerPtr> checkers;     ///< one for each worker, or one for all
        std::vector<ompl::base::MotionValidatorPtr> motionValidators;  ///< one for each worker, or one for all
    };

    explicit OmplChecker(const ompl::base::SpaceInformation& si, unsigned workers);

    /// Checks for this lattice from now on; all of it must outlive the checks.
    /// \param costs of an objective; nullptr for path length.
    void open(const lattice::Lattice& lattice, const Embedding& embedding, Sources sources, ObjectiveCosts* costs);

    /// \param stop is looked at inside of motions; nullptr for never. Must outlive the checks.
    void setStopSignal(validity::StopSignal* stop) noexcept
    {
        stop_ = stop;
    }

    bool check(validity::CheckId check, unsigned worker) override;

    [[nodiscard]] bool stopsInside() const noexcept override
    {
        return discrete_;
    }

    /// States that the last check of a worker looked at; 0 for a motion without inner states.
    [[nodiscard]] std::uint32_t statesOfLastCheck(unsigned worker) const noexcept
    {
        return scratch_[worker].states;
    }

    /// The lattice whose checks these are.
    [[nodiscard]] const lattice::Lattice& lattice() const noexcept
    {
        return *lattice_;
    }

    /// Where checks of motions leave the costs of these; nullptr for path length.
    [[nodiscard]] ObjectiveCosts* costs() const noexcept
    {
        return costs_;
    }

    /// Whether motions are tested by discretisation, so that a motion of one segment needs no check besides its ends.
    [[nodiscard]] bool isDiscrete() const noexcept
    {
        return discrete_;
    }

private:
    static constexpr std::uint32_t kAllStates = std::numeric_limits<std::uint32_t>::max();

    /// One worker's own; on a cache line of its own.
    struct alignas(64) Scratch
    {
        std::uint32_t states = 0;
        validity::StopSignal::Look look;
    };

    /// Unchecked inner states [first, last] of a motion; those beside it are checked, or ends.
    struct Gap
    {
        unsigned first;
        unsigned last;
    };

    [[nodiscard]] bool checkState(lattice::NodeId node, unsigned worker);
    [[nodiscard]] bool checkMotion(lattice::MotionId id, unsigned worker);
    [[nodiscard]] bool askValidator(const ompl::base::State* from, const ompl::base::State* to, unsigned worker);
    [[nodiscard]] bool checkGlance(lattice::MotionId glance, const ompl::base::State* from, const ompl::base::State* to,
                                   unsigned worker);
    [[nodiscard]] bool checkInside(const ompl::base::State* from, const ompl::base::State* to, unsigned worker,
                                   std::uint32_t seen, std::uint32_t most);
    [[nodiscard]] bool isBeside(const ompl::base::State* state, const ompl::base::State* from,
                                const ompl::base::State* to, double segments, Gap gap) const;
    [[nodiscard]] std::uint32_t seenOf(lattice::MotionId motion);
    void evaluateCost(lattice::MotionId motion, const ompl::base::State* from, const ompl::base::State* to,
                      unsigned worker);
    void breakOffIfTold(unsigned worker);
    void waitFor(std::unique_lock<std::timed_mutex>& lock, unsigned worker);
    [[nodiscard]] const ompl::base::StateValidityChecker& checkerOf(unsigned worker) const noexcept;

    const ompl::base::SpaceInformation& si_;
    const lattice::Lattice* lattice_ = nullptr;
    const Embedding* embedding_ = nullptr;
    ObjectiveCosts* costs_ = nullptr;
    Sources sources_;
    validity::StopSignal* stop_ = nullptr;
    bool discrete_ = true;
    bool rounds_ = false;               ///< states in between may be equal to others
    bool costsAlone_ = false;           ///< the objective is called by one thread at a time
    std::timed_mutex sharedValidator_;  ///< held while the shared motion validator runs
    std::timed_mutex sharedObjective_;  ///< held while the objective runs, if it must be alone
    std::mutex glancesMutex_;
    std::unordered_set<lattice::MotionId> glanced_;  ///< motions whose glance is valid; guarded by glancesMutex_
    std::vector<Scratch> scratch_;
};

/// Whether a motion validator is exactly one of OMPL's that look at states one after the other.
[[nodiscard]] bool isDiscreteMotionValidator(const ompl::base::MotionValidator& validator);
}  // namespace specplan::planner
