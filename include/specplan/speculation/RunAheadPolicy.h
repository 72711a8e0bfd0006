// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
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
/// ahead, with an OPEN list and g-values of its own. It goes through states whose verdicts are still open, but the less
/// likely the search is to get to a node, the later its turn: each node carries the product of the probabilities on the
/// way to it, and its place on the shadow's OPEN is f - caution * scale * log(probability). The shadow lives on from
/// call to call. While verdicts agree with what was likely, probabilities rise; when one says "invalid", what the
/// shadow had reached through that state is taken back and joined again to what is still right. See docs/algorithm.md,
/// "Run-ahead".
///
/// Nothing depends on the shadow being exact: it only decides what is checked ahead.
///
/// Threads: search thread only.
class RunAheadPolicy : public Policy
{
public:
    /// All references must outlive the policy. \param weight of the heuristic: the greedier the search, the straighter
    /// the shadow follows the likeliest way.
    RunAheadPolicy(lattice::Lattice& lattice, const validity::Broker& broker, const FrontierView& frontier,
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
    static constexpr double kNotAsked = std::numeric_limits<double>::quiet_NaN();

    enum class Status : std::uint8_t
    {
        Unseen,
        Open,
        Closed
    };

    struct Node
    {
        double g = std::numeric_limits<double>::infinity();
        double h = kNotAsked;        ///< weighted
        double probability = 1.0;    ///< that the search gets here: of its state, its motion and its parent
        double delay = 0.0;          ///< how much later it has its turn, in average steps of f
        std::uint64_t closedAs = 0;  ///< number of the shadow's expansion that closed it
        lattice::NodeId parent = lattice::kNoNode;
        lattice::NodeId askedFrom = lattice::kNoNode;  ///< expansion that wanted the state's check
        std::optional<lattice::CheckId> motion;        ///< the check of the motion from the parent
        bool guarded = false;                          ///< that motion needs states beside it, too
        std::uint16_t step = 0;                        ///< place of that motion among those of the parent
        std::uint32_t expandedAs = 0;                  ///< number of the search's expansion, as far as it was followed
        float ofState = 1.0F;                          ///< that the state is valid
        float ofMotion = 1.0F;                         ///< that the motion from the parent is
        Status status = Status::Unseen;
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

    // Keeping up with the search.
    void synchronise();
    void importFrontier();
    void follow(lattice::NodeId node);
    void followWaysFrom(lattice::NodeId node);

    // Running ahead of it.
    [[nodiscard]] bool advance();
    void relaxFrom(lattice::NodeId node);
    void relax(lattice::NodeId from, const lattice::Successors::Edge& edge);
    [[nodiscard]] double checkMotion(lattice::NodeId from, const lattice::Successors::Edge& edge, bool endIsValid);
    void takeWay(Node& end, lattice::NodeId from, const lattice::Successors::Edge& edge, double g);
    void settleTie(lattice::NodeId from, const lattice::Successors::Edge& edge, double g, lattice::CheckId motion);
    [[nodiscard]] bool isFoundBefore(lattice::NodeId from, double g, const Node& end) const;
    void push(lattice::NodeId id);
    void emit(lattice::CheckId check, lattice::NodeId from);
    void emitMotionTo(lattice::NodeId id, lattice::NodeId from);

    // Repair: RunAheadRepair.cpp.
    void confirmState(lattice::NodeId id);
    void confirmMotion(lattice::NodeId id);
    void emitGuardsOf(lattice::NodeId id);
    void raise(lattice::NodeId root, double known, double delay);
    [[nodiscard]] double delayFor(double probability) const;
    [[nodiscard]] double delayForMotion(double probability) const;
    void forget(lattice::NodeId id);
    void retract(lattice::NodeId root);
    void retractGuarded(lattice::CheckId guard);

    [[nodiscard]] bool isGuardedBy(lattice::NodeId end, lattice::CheckId guard);
    [[nodiscard]] bool isClosed(lattice::NodeId node) const;
    [[nodiscard]] bool leadsOn(const Pending& pending) const;
    [[nodiscard]] bool isOnTheWay(lattice::CheckId motion) const;
    [[nodiscard]] bool isChild(lattice::NodeId node, lattice::NodeId parent) const;
    [[nodiscard]] bool isExpandedBefore(lattice::NodeId node, lattice::NodeId other) const;
    [[nodiscard]] bool wouldComeFirst(const Node& node, const Node& other) const;
    [[nodiscard]] double costOf(const lattice::Successors::Edge& edge) const;
    void noteStep(double change);
    [[nodiscard]] double estimateThrough(const Node& node) const;
    void makeRoom();
    /// May move the nodes, unless makeRoom() has been called since the lattice last grew.
    Node& touch(lattice::NodeId node);

    lattice::Lattice& lattice_;
    const validity::Broker& broker_;
    const FrontierView& frontier_;
    Predictor& predictor_;
    lattice::CostSum sum_;
    double caution_;

    bool imported_ = false;
    bool moves_ = false;                            ///< steps need checks of their motion
    bool guarded_ = false;                          ///< steps need the states of further nodes
    std::optional<lattice::CheckId> motionToGoal_;  ///< proposed while the shadow waits at a goal
    lattice::NodeId expanding_ = lattice::kNoNode;  ///< the search is at this node
    std::vector<lattice::NodeId> behind_;           ///< expanded by the search, not yet by the shadow
    std::vector<Node> nodes_;
    util::OpenList open_;
    double scale_ = 0.0;  ///< by how much f changes from a node to its successors, on average
    double steps_ = 0.0;  ///< how many steps that average has seen, up to its memory
    std::uint64_t pushes_ = 0;
    std::uint64_t expansions_ = 0;
    std::uint32_t followed_ = 0;  ///< expansions of the search
    std::priority_queue<Pending, std::vector<Pending>, std::greater<>> pending_;
    std::vector<lattice::NodeId> subtree_;     ///< scratch
    std::vector<lattice::NodeId> neighbours_;  ///< scratch
    std::vector<lattice::NodeId> rim_;         ///< scratch
    lattice::Successors successors_;           ///< scratch
    lattice::Successors around_;               ///< scratch
};
}  // namespace specplan::speculation
