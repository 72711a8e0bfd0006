// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "specplan/speculation/RunAheadPolicy.h"

namespace specplan::speculation
{
/// Two shadows of a greedy search: one expects what is likely, the other one that all doubtful states are invalid. They
/// propose in turn.
///
/// Idea: with a large weight the search goes straight ahead until it is stopped. A single shadow does the same: it goes
/// through a state that is valid with probability 0.6, and in four of ten cases all that lies behind is lost. With many
/// workers half of them do better to look where the search turns to then.
///
/// Threads: search thread only.
class HedgedPolicy : public Policy
{
public:
    /// All references must outlive the policy. \param weight of the heuristic.
    HedgedPolicy(lattice::Lattice& lattice, const validity::Broker& broker, const FrontierView& frontier,
                 Predictor& predictor, double weight);

    void expanding(lattice::NodeId node, lattice::NodeId parent) override;
    void propose(std::size_t count, std::vector<lattice::CheckId>& out) override;
    void learned(lattice::CheckId check, bool valid) override;
    void missed() override;
    [[nodiscard]] bool stillWanted(lattice::CheckId check) const override;

    [[nodiscard]] bool keepsAsking() const noexcept override
    {
        return true;
    }

private:
    /// Takes for invalid what is not likely to be valid. Learns nothing: the other predictor does.
    class WaryPredictor : public Predictor
    {
    public:
        explicit WaryPredictor(const Predictor& predictor) : predictor_(predictor)
        {
        }

        [[nodiscard]] double probabilityValid(lattice::NodeId node) const override;
        [[nodiscard]] double probabilityMotionValid() const override
        {
            return predictor_.probabilityMotionValid();
        }
        void learned(lattice::NodeId, bool) override
        {
        }
        void learnedMotion(bool) override
        {
        }

    private:
        const Predictor& predictor_;
    };

    [[nodiscard]] bool proposeOne(Policy& shadow, std::vector<lattice::CheckId>& out);

    WaryPredictor waryPredictor_;
    RunAheadPolicy likely_;
    RunAheadPolicy wary_;
    bool waryNext_ = false;
    std::vector<lattice::CheckId> one_;  ///< scratch
};

/// Run-ahead for a search with this weight and so many workers: two shadows if it is greedy and they are many.
[[nodiscard]] std::unique_ptr<Policy> makeRunAhead(lattice::Lattice& lattice, const validity::Broker& broker,
                                                   const FrontierView& frontier, Predictor& predictor, double weight,
                                                   unsigned workers);
}  // namespace specplan::speculation
