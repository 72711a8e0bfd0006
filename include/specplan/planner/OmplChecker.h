// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "specplan/planner/Embedding.h"
#include "specplan/planner/ObjectiveCosts.h"
#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/validity/Checker.h"

namespace specplan::planner
{
/// Answers checks through OMPL's state validity checkers and motion validators.
///
/// OMPL's DiscreteMotionValidator, and those for Dubins and Reeds-Shepp cars, count their calls in plain integers,
/// which is a data race when two threads use them. They are replaced by the same test: the inner states of
/// Embedding::segments(). Any other motion validator is called as it is: each worker's own if there is one, otherwise
/// the shared one by one thread at a time. A motion that is valid also gets its cost, where an objective tells it.
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

    bool check(validity::CheckId check, unsigned worker) override;

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
    };

    [[nodiscard]] bool checkState(lattice::NodeId node, unsigned worker);
    [[nodiscard]] bool checkMotion(lattice::MotionId id, unsigned worker);
    [[nodiscard]] bool askValidator(const ompl::base::State* from, const ompl::base::State* to, unsigned worker);
    [[nodiscard]] bool checkInside(const ompl::base::State* from, const ompl::base::State* to, unsigned worker,
                                   std::uint32_t most);
    [[nodiscard]] const ompl::base::StateValidityChecker& checkerOf(unsigned worker) const noexcept;

    const ompl::base::SpaceInformation& si_;
    const lattice::Lattice* lattice_ = nullptr;
    const Embedding* embedding_ = nullptr;
    ObjectiveCosts* costs_ = nullptr;
    Sources sources_;
    bool discrete_ = true;
    std::mutex sharedValidator_;  ///< held while the shared motion validator runs
    std::vector<Scratch> scratch_;
};

/// Whether a motion validator is exactly one of OMPL's that look at states one after the other.
[[nodiscard]] bool isDiscreteMotionValidator(const ompl::base::MotionValidator& validator);
}  // namespace specplan::planner
