// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/Embedding.h"

#include <algorithm>
#include <cmath>

#include <ompl/util/Exception.h>

#include "specplan/lattice/GridNeighbourhood.h"
#include "specplan/lattice/ProductNeighbourhood.h"
#include "specplan/planner/spaces/AxesComponent.h"

namespace specplan::planner
{
namespace ob = ompl::base;
using lattice::Coordinate;

namespace
{
/// A state off the lattice is joined to no more nodes than this; beyond, only to the nearest and those next to it.
constexpr std::size_t kMaxCorners = 1024;
}  // namespace

Embedding::Embedding(const ob::SpaceInformation& si, const PlannerSettings& settings, const SpaceHooks& hooks,
                     const ob::State* origin, bool coarsens)
    : si_(si),
      settings_(settings),
      hooks_(hooks),
      decomposition_(decompose(si.getStateSpace(), hooks_)),
      components_(makeComponents(decomposition_, settings, origin, coarsens))
{
    std::size_t dimension = 0;
    for (const auto& component : components_.all)
    {
        firstCoordinate_.push_back(dimension);
        dimension += component->dimension();
    }
    if (std::ranges::find(components_.begunCoarse, true) != components_.begunCoarse.end())
    {
        spacing_ = Spacing::Coarse;
        refine();
        level_ = 0;
    }
    curves_ = !decomposition_.sumsDistances ||
              std::ranges::any_of(decomposition_.parts, [](const Part& part) { return isCar(*part.space); });
}

std::unique_ptr<const lattice::Neighbourhood> Embedding::neighbourhood(bool discreteMotions) const
{
    // One grid is by far the most usual, has a faster neighbourhood, and is the only one whose corners can be guarded.
    const auto* axes = dynamic_cast<const AxesComponent*>(components_.all.front().get());
    if (components_.all.size() == 1 && axes != nullptr && axes->isPlain())
        return axes->grid(discreteMotions, settings_.cornerCutting);
    if (!settings_.cornerCutting)
        throw ompl::Exception("corner_cutting can be switched off in RealVectorStateSpaces only");
    std::vector<std::unique_ptr<const lattice::Factor>> factors;
    for (const auto& component : components_.all)
        factors.push_back(component->factor(discreteMotions));
    return std::make_unique<lattice::ProductNeighbourhood>(std::move(factors), components_.connectivity);
}

bool Embedding::refine()
{
    bool refined = false;
    for (std::size_t i = 0; i < components_.all.size(); ++i)
    {
        if (isCoarse() && !components_.begunCoarse[i])
            continue;
        refined = refined || components_.all[i]->canRefine();
        components_.all[i]->refine();
    }
    spacing_ = isCoarse() ? Spacing::Usual : Spacing::Fixed;
    ++level_;
    return refined;
}

void Embedding::coarsen()
{
    for (std::size_t i = 0; i < components_.all.size(); ++i)
        if (components_.begunCoarse[i])
            components_.all[i]->coarsen();
    spacing_ = Spacing::Coarse;
    --level_;
}

double Embedding::coarseness() const
{
    double coarsest = 0.0;
    for (const auto& component : components_.all)
        coarsest = std::max(coarsest, component->coarseness());
    return coarsest;
}

std::vector<Embedding::Coordinates> Embedding::corners(const ob::State* state, Joint joint) const
{
    std::vector<Coordinates> corners(1);
    std::vector<std::vector<Coordinates>> ofParts;
    std::size_t count = 1;
    for (std::size_t i = 0; i < components_.all.size(); ++i)
    {
        ofParts.push_back(components_.all[i]->corners(decomposition_.parts[i].of(state), joint));
        count *= std::min(ofParts.back().size(), kMaxCorners + 1);
        count = std::min(count, kMaxCorners + 1);
    }
    for (const std::vector<Coordinates>& ofPart : ofParts)
    {
        if (ofPart.empty())
            return {};
        std::vector<Coordinates> longer;
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t k = 0; k < ofPart.size(); ++k)
            {
                if (count > kMaxCorners && i > 0 && k > 0)
                    break;  // no more than one part off its nearest node
                longer.push_back(corners[i]);
                longer.back().insert(longer.back().end(), ofPart[k].begin(), ofPart[k].end());
            }
        corners = std::move(longer);
    }
    return corners;
}

Embedding::Target Embedding::target(const ob::State* state, bool exactly) const
{
    Target target;
    for (std::size_t i = 0; i < components_.all.size(); ++i)
        target.push_back(components_.all[i]->target(decomposition_.parts[i].of(state), exactly));
    return target;
}

double Embedding::lowerBound(const Coordinate* node, const Target& target) const
{
    double bound = 0.0;
    for (std::size_t i = 0; i < components_.all.size(); ++i)
        bound += components_.all[i]->lowerBound(node + firstCoordinate_[i], target[i]);
    return bound;
}

void Embedding::addTerminal(const ob::State* state)
{
    terminals_.emplace_back(si_, state);
}

void Embedding::write(const lattice::Lattice& lattice, lattice::NodeId node, ob::State* state) const
{
    if (lattice.isTerminal(node))
    {
        si_.copyState(state, terminals_[lattice.terminalIndex(node)].get());
        return;
    }
    const Coordinate* coordinates = lattice.coordinates(node).data();
    for (std::size_t i = 0; i < components_.all.size(); ++i)
        components_.all[i]->write(coordinates + firstCoordinate_[i], decomposition_.parts[i].of(state));
    if (hooks_.complete)
        hooks_.complete(state);
}

unsigned Embedding::segments(const ob::State* from, const ob::State* to) const
{
    const unsigned ompls = std::max(si_.getStateSpace()->validSegmentCount(from, to), 1U);
    unsigned needed = ompls;
    for (const Part& part : decomposition_.parts)
    {
        if (!isCar(*part.space))
            continue;
        const double length = part.space->distance(part.of(from), part.of(to));
        const double count = std::ceil(length / part.space->getLongestValidSegmentLength());
        needed = std::max(needed, part.space->getValidSegmentCountFactor() * static_cast<unsigned>(count));
    }
    // A multiple of OMPL's count, so that the states that OMPL's validator looks at are among those looked at here.
    return (needed + ompls - 1) / ompls * ompls;
}

double Embedding::nodes() const
{
    double nodes = 1.0;
    for (const auto& component : components_.all)
        nodes *= component->nodes();
    return nodes;
}

void Embedding::describe(std::ostream& out) const
{
    for (const auto& component : components_.all)
        component->describe(out);
}
}  // namespace specplan::planner
