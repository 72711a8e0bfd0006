// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "specplan/lattice/Lattice.h"
#include "specplan/speculation/FrontierView.h"
#include "specplan/speculation/Policy.h"
#include "specplan/speculation/Predictor.h"
#include "specplan/util/OpenList.h"
#include "specplan/validity/Broker.h"

namespace specplan::speculation
{
/// Runs a shadow of the search ahead of it and proposes the checks that the shadow meets, in the order in which it
/// meets them.
///
/// Idea: if every open check came out as predicted, A* would go on in a way that is known in advance. So A* itself runs
/// ahead, with an OPEN list and g-values of its own, and takes unknown states for what the predictor says. The shadow
/// lives on from call to call. While predictions hold, the search merely follows it. When a verdict contradicts its
/// prediction, what the shadow had reached through that state is taken back and joined again to what is still right.
///
/// Nothing depends on the shadow being exact: it only decides what is checked ahead.
///
/// Threads: search thread only.
class RunAheadPolicy : public Policy
{
public:
    /// All references must outlive the policy.
    RunAheadPolicy(lattice::Lattice& lattice, const validity::Broker& broker, const FrontierView& frontier,
                   Predictor& predictor);

    void expanding(lattice::NodeId node, lattice::NodeId parent) override;
    void propose(std::size_t count, std::vector<lattice::CheckId>& out) override;
    void learned(lattice::CheckId check, bool valid) override;

    [[nodiscard]] bool keepsAsking() const noexcept override
    {
        return true;
    }

private:
    enum class Status : std::uint8_t
    {
        Unseen,
        Open,
        Closed
    };

    struct Node
    {
        double g = std::numeric_limits<double>::infinity();
        double h = -1.0;  ///< weighted; negative: not asked yet
        lattice::NodeId parent = lattice::kNoNode;
        Status status = Status::Unseen;
        bool heldBack = false;       ///< reached, but predicted to be invalid
        std::uint64_t closedAs = 0;  ///< number of the shadow's expansion that closed it
    };

    /// A check that the shadow has met and that is not handed out yet; the one met first comes first.
    struct Pending
    {
        std::uint64_t order;
        std::uint64_t age;
        lattice::CheckId check;
        lattice::NodeId from;

        [[nodiscard]] bool operator>(const Pending& other) const noexcept
        {
            return order != other.order ? order > other.order : age > other.age;
        }
    };

    void synchronise();
    void importFrontier();
    void follow(lattice::NodeId node);
    [[nodiscard]] bool advance();
    void relaxFrom(lattice::NodeId node);
    void relax(lattice::NodeId from, const lattice::Successors::Edge& edge);
    void retract(lattice::NodeId root);
    void emit(lattice::CheckId check, lattice::NodeId from);
    [[nodiscard]] bool isClosed(lattice::NodeId node) const;
    Node& touch(lattice::NodeId node);

    lattice::Lattice& lattice_;
    const validity::Broker& broker_;
    const FrontierView& frontier_;
    Predictor& predictor_;

    bool imported_ = false;
    std::vector<lattice::NodeId> behind_;  ///< expanded by the search, not yet by the shadow
    std::vector<Node> nodes_;
    util::OpenList open_;
    std::uint64_t pushes_ = 0;
    std::uint64_t expansions_ = 0;
    std::priority_queue<Pending, std::vector<Pending>, std::greater<>> pending_;
    std::vector<lattice::NodeId> subtree_;
    std::vector<lattice::NodeId> rim_;
    lattice::Successors successors_;
    lattice::Successors around_;
};
}  // namespace specplan::speculation
