// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/LatticeFit.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include <ompl/util/Exception.h>

#include "specplan/lattice/Lattice.h"
#include "specplan/planner/StateHandle.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
/// The way over a point of a straight motion is as long as the motion, but for what a class of one's own rounds or
/// bends a little.
constexpr double kLongestDetour = 1.5;

[[noreturn]] void refuse(const ob::StateSpace& space, const std::string& reason)
{
    throw ompl::Exception("there is no lattice over the state space '" + space.getName() + "': " + reason);
}

/// Whether a class of OMPL's own has this name, which older versions do not know.
bool isOmplsOwn(const ob::StateSpace& space, std::string_view className)
{
    const std::string_view name(typeid(space).name());
    return name.starts_with("N4ompl4base") && name.find(className) != name.npos;
}

/// The motions out of one node, as the space and as its parts see them.
class Motions
{
public:
    Motions(const ob::SpaceInformation& si, const Embedding& embedding, const ob::State* origin)
        : si_(si),
          embedding_(embedding),
          lattice_(embedding.neighbourhood(true)),
          from_(si),
          to_(si),
          middle_(si),
          finite_(embedding.parts().size(), false),
          steps_(embedding.parts().size(), false)
    {
        const lattice::NodeId node = lattice_.node(embedding.corners(origin, Embedding::Joint::Leaving).front().data());
        embedding.write(lattice_, node, from_.get());
        lattice::Successors successors;
        lattice_.successors(node, successors);
        for (const lattice::Successors::Edge& edge : successors.edges)
            look(edge.node);
    }

    /// Longest way over the middle of a motion, as a multiple of the motion itself.
    [[nodiscard]] double longestDetour() const noexcept
    {
        return longestDetour_;
    }

    /// A part that can step, but for which every step of its own is infinitely long; the number of parts if there is
    /// none.
    [[nodiscard]] std::size_t stuckPart() const
    {
        for (std::size_t i = 0; i < steps_.size(); ++i)
            if (steps_[i] && !finite_[i])
                return i;
        return steps_.size();
    }

private:
    void look(lattice::NodeId node)
    {
        embedding_.write(lattice_, node, to_.get());
        const std::vector<std::size_t> moved = partsThatMove();
        const bool finite = std::isfinite(si_.distance(from_.get(), to_.get()));
        if (moved.size() == 1)
        {
            steps_[moved.front()] = true;
            finite_[moved.front()] = finite_[moved.front()] || finite;
        }
        if (!finite)
            return;
        si_.getStateSpace()->interpolate(from_.get(), to_.get(), 0.5, middle_.get());
        const double direct = byParts(from_.get(), to_.get());
        const double detour = byParts(from_.get(), middle_.get()) + byParts(middle_.get(), to_.get());
        if (direct > 0.0)
            longestDetour_ = std::max(longestDetour_, detour / direct);
    }

    [[nodiscard]] std::vector<std::size_t> partsThatMove() const
    {
        std::vector<std::size_t> moved;
        for (std::size_t i = 0; i < embedding_.parts().size(); ++i)
            if (const Part& part = embedding_.parts()[i];
                !part.space->equalStates(part.of(from_.get()), part.of(to_.get())))
                moved.push_back(i);
        return moved;
    }

    [[nodiscard]] double byParts(const ob::State* a, const ob::State* b) const
    {
        double sum = 0.0;
        for (const Part& part : embedding_.parts())
            sum += part.space->distance(part.of(a), part.of(b));
        return sum;
    }

    const ob::SpaceInformation& si_;
    const Embedding& embedding_;
    lattice::Lattice lattice_;
    StateHandle from_;
    StateHandle to_;
    StateHandle middle_;
    std::vector<bool> finite_;
    std::vector<bool> steps_;
    double longestDetour_ = 1.0;
};
}  // namespace

void requireFit(const ob::SpaceInformation& si, const Embedding& embedding, const ob::State* origin)
{
    if (embedding.sumsDistances())
        return;
    const ob::StateSpace& space = *si.getStateSpace();
    if (isOmplsOwn(space, "KleinBottleStateSpace"))
        refuse(space,
               "its ends are glued together the other way round, which a lattice over its values does not know; "
               "a sampling planner does");
    if (embedding.corners(origin, Embedding::Joint::Leaving).empty())
        return;
    const Motions motions(si, embedding, origin);
    if (const std::size_t stuck = motions.stuckPart(); stuck < embedding.parts().size())
        refuse(space,
               "every step of its part '" + embedding.parts()[stuck].space->getName() +
                   "' alone is infinitely long by its distance(), as where time and place are tied by a greatest "
                   "speed; plan with a planner for such spaces");
    if (motions.longestDetour() > kLongestDetour)
        refuse(space,
               "its motions are curves that leave the cells of a lattice (by interpolate(), the middle of a "
               "step lies off it), as those of aircraft are; plan with a sampling planner");
}
}  // namespace specplan::planner
