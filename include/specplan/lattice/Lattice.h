// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "specplan/lattice/CheckId.h"
#include "specplan/lattice/MotionCosts.h"
#include "specplan/lattice/Neighbourhood.h"
#include "specplan/lattice/NodeRows.h"
#include "specplan/lattice/NodeTable.h"

namespace specplan::lattice
{
/// The motions out of one node. Kept by the caller and used again.
struct Successors
{
    struct Edge
    {
        NodeId node;               ///< where the motion ends
        double cost;               ///< cost of the motion; only a lower bound where Lattice::motionCosts() are set
        std::uint32_t firstInner;  ///< checks of the motion: [firstInner, firstInner + inner) of Successors::inner
        std::uint32_t inner;       ///< number of checks that have to hold besides the end state's; often 0
    };

    std::vector<Edge> edges;
    std::vector<CheckId> inner;

    /// The check of the motion's inside, if it needs one.
    [[nodiscard]] std::optional<CheckId> motionOf(const Edge& edge) const noexcept
    {
        if (edge.inner == 0 || !inner[edge.firstInner + edge.inner - 1].isMotion())
            return std::nullopt;
        return inner[edge.firstInner + edge.inner - 1];
    }

    /// The states beside the motion that have to be valid.
    [[nodiscard]] std::span<const CheckId> guardsOf(const Edge& edge) const noexcept
    {
        return innerOf(edge).first(edge.inner - (motionOf(edge) ? 1 : 0));
    }

    /// All checks of the motion besides that of its end: guards first, then its inside.
    [[nodiscard]] std::span<const CheckId> innerOf(const Edge& edge) const noexcept
    {
        return std::span(inner).subspan(edge.firstInner, edge.inner);
    }
};

/// The implicit graph: regular nodes made on demand by a neighbourhood, plus terminals (starts and goals that lie off
/// the grid) that are connected by hand.
///
/// Threads: the search thread owns it. `coordinates` and `motion` may be read by workers for checks handed to them.
class Lattice
{
public:
    struct Motion
    {
        NodeId from = kNoNode;
        NodeId to = kNoNode;
    };

    explicit Lattice(std::unique_ptr<const Neighbourhood> neighbourhood);

    [[nodiscard]] std::size_t dimension() const noexcept
    {
        return nodes_.dimension();
    }

    /// Number of steps out of a node, at most; those made by hand come on top.
    [[nodiscard]] std::uint32_t maxSteps() const noexcept
    {
        return neighbourhood_->maxSteps();
    }

    /// Number of nodes touched so far, terminals included.
    [[nodiscard]] std::size_t size() const noexcept
    {
        return nodes_.size();
    }

    /// The node at these coordinates, which must lie inside the neighbourhood's bounds.
    NodeId node(const Coordinate* coordinates)
    {
        return nodes_.intern(coordinates);
    }

    /// The node at these coordinates, or kNoNode if it was never touched.
    [[nodiscard]] NodeId find(const Coordinate* coordinates) const noexcept
    {
        return nodes_.find(coordinates);
    }

    /// Steps are those of another neighbourhood from now on; nodes and what is known of them stay. For coarser and
    /// finer steps on the same coordinates. \param level steps that come back under the number that they had keep their
    /// motions, with all that is known of them. Those of the beginning are number 0.
    void setNeighbourhood(std::unique_ptr<const Neighbourhood> neighbourhood, int level);

    /// A new node off the grid, without motions until `connect` makes some.
    NodeId addTerminal();

    /// Whether a node was made by addTerminal.
    [[nodiscard]] bool isTerminal(NodeId node) const noexcept
    {
        return *nodes_.coordinates(node).data() < kTerminalEnd;
    }

    /// Number of a terminal, from 0 in the order of making.
    [[nodiscard]] std::size_t terminalIndex(NodeId node) const noexcept;

    /// Adds a motion by hand, with a check of its own. A motion that was there before keeps its check.
    void connect(NodeId from, NodeId to, double cost);

    /// Takes all motions that `connect` made out of the graph. They come back, with their checks, when they are
    /// connected again.
    void disconnectAll();

    /// For costs that depend on more than the step; without it a step costs what the neighbourhood says.
    void setStepCost(std::function<double(NodeId from, NodeId to)> cost)
    {
        stepCost_ = std::move(cost);
    }

    /// For costs that only a check tells: every motion has a check of its own then. \param costs must outlive the
    /// lattice; to be set before the first motion is made.
    void setMotionCosts(MotionCosts* costs) noexcept
    {
        motionCosts_ = costs;
    }

    [[nodiscard]] const MotionCosts* motionCosts() const noexcept
    {
        return motionCosts_;
    }

    /// Gives every motion of a step a second check, its glance: whoever checks decides what of the motion it looks at,
    /// and where a glance is invalid the motion is. To be set before the first motion is made.
    void setGlances(bool glances) noexcept
    {
        glances_ = glances;
    }

    [[nodiscard]] bool hasGlances() const noexcept
    {
        return glances_;
    }

    /// The glance of a motion, if it has one.
    [[nodiscard]] std::optional<MotionId> glanceOf(MotionId motion) const noexcept;

    [[nodiscard]] bool isGlance(MotionId motion) const noexcept
    {
        return motions_[motion].to == kGlance;
    }

    /// The motion that a glance is of; any other motion itself.
    [[nodiscard]] MotionId glancedAt(MotionId motion) const noexcept
    {
        return isGlance(motion) ? motions_[motion].from : motion;
    }

    /// Number of motions made so far, glances included.
    [[nodiscard]] std::size_t motions() const noexcept
    {
        return motions_.size();
    }

    /// Writes all motions out of a node, always in the same order.
    void successors(NodeId node, Successors& out);

    /// Writes the ends of all motions out of a node, in the same order. Much faster than `successors` for a node that
    /// has been met before.
    void neighbours(NodeId node, std::vector<NodeId>& out);

    /// Whether `neighbours` is as fast as it gets.
    [[nodiscard]] bool knowsNeighbours(NodeId node) const noexcept
    {
        return needsMotions() ? hasMotions(node) : tables_.ends.has(node);
    }

    /// The node that lies from `to` as `to` lies from `from`, if there is such a step.
    std::optional<NodeId> goOn(NodeId from, NodeId to);

    [[nodiscard]] std::span<const Coordinate> coordinates(NodeId node) const noexcept
    {
        return nodes_.coordinates(node);
    }

    /// The ends of a motion; of a glance those of the motion that it is of.
    [[nodiscard]] const Motion& motion(MotionId motion) const noexcept
    {
        return motions_[glancedAt(motion)];
    }

private:
    /// First coordinates below this mark terminals.
    static constexpr Coordinate kTerminalEnd = std::numeric_limits<Coordinate>::min() / 2;

    /// In place of a motion's end: this is a glance, and `from` the number of the motion.
    static constexpr NodeId kGlance = kNoNode - 1;

    struct HandMade
    {
        NodeId to;
        double cost;
        MotionId motion;
        bool connected;
    };

    /// What is remembered of a neighbourhood's steps.
    struct StepTables
    {
        explicit StepTables(const Neighbourhood& neighbourhood) : ends(neighbourhood.maxSteps())
        {
        }

        std::vector<MotionId> firstMotion;  ///< node -> first of its maxSteps() motions, once it was asked for; their
                                            ///< glances come next
        NodeRows ends;                      ///< where no motion is checked: ends by the steps' index
    };

    /// The end of a step that is not known yet.
    struct UnknownEnd
    {
        std::uint64_t hash;  ///< of its coordinates
        std::size_t step;
    };

    MotionId motionsOf(NodeId node);
    [[nodiscard]] bool needsMotions() const noexcept
    {
        return motionCosts_ != nullptr || neighbourhood_->hasMotionChecks();
    }
    [[nodiscard]] bool hasMotions(NodeId node) const noexcept;
    template <typename KnownEnd>
    void internEnds(KnownEnd known);
    void meet(NodeId node);
    void addEnds(NodeId node, std::vector<NodeId>& out);
    void addSteps(NodeId node, Successors& out);
    void addPatterns(NodeId node, std::span<const Neighbourhood::Pattern> patterns, Successors& out);
    template <typename EndOf>
    void addPatterns(NodeId node, std::span<const Neighbourhood::Pattern> patterns, MotionId first, EndOf endOf,
                     Successors& out) const;
    void addHandMade(NodeId node, Successors& out) const;
    [[nodiscard]] double costOf(NodeId from, NodeId to, double ofStep) const;
    MotionId addMotion(NodeId from, NodeId to);

    std::unique_ptr<const Neighbourhood> neighbourhood_;
    NodeTable nodes_;
    util::SegmentedRows<Motion> motions_;
    StepTables tables_;
    int level_ = 0;
    std::map<int, StepTables> otherTables_;  ///< by level
    std::unordered_map<NodeId, std::vector<HandMade>> handMade_;
    std::function<double(NodeId, NodeId)> stepCost_;
    MotionCosts* motionCosts_ = nullptr;
    bool glances_ = false;
    std::size_t terminals_ = 0;
    Steps steps_;                      ///< scratch of successors()
    std::vector<UnknownEnd> unknown_;  ///< scratch of internEnds()
    std::vector<Coordinate> next_;
};
}  // namespace specplan::lattice
