// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/lattice/ProductNeighbourhood.h"

#include <algorithm>
#include <stdexcept>

namespace specplan::lattice
{
namespace
{
constexpr std::size_t kMaxSteps = 65536;
}  // namespace

ProductNeighbourhood::ProductNeighbourhood(std::vector<std::unique_ptr<const Factor>> factors, unsigned connectivity)
    : factors_(std::move(factors))
{
    if (factors_.empty())
        throw std::invalid_argument("a lattice needs at least one factor");
    for (const auto& factor : factors_)
    {
        firstCoordinate_.push_back(dimension_);
        dimension_ += factor->dimension();
    }
    std::vector<Part> parts;
    addPatterns(0, connectivity, parts);
}

/// Enters every choice of steps of the factors from `factor` on, beside the parts chosen so far.
void ProductNeighbourhood::addPatterns(std::size_t factor, unsigned axesLeft, std::vector<Part>& parts)
{
    if (factor == factors_.size())
    {
        if (parts.empty())
            return;
        if (patterns_.size() == kMaxSteps)
            throw std::invalid_argument("a node has more than 65536 neighbours; choose a smaller connectivity");
        patterns_.push_back({parts_.size(), parts_.size() + parts.size()});
        parts_.insert(parts_.end(), parts.begin(), parts.end());
        return;
    }
    addPatterns(factor + 1, axesLeft, parts);
    for (std::uint32_t step = 0; step < factors_[factor]->steps(); ++step)
    {
        const unsigned axes = factors_[factor]->axes(step);
        // A factor's own steps are its own affair; only together with others they have to share.
        if (!parts.empty() && axes > axesLeft)
            continue;
        parts.push_back({static_cast<std::uint32_t>(factor), step});
        addPatterns(factor + 1, axes < axesLeft ? axesLeft - axes : 0, parts);
        parts.pop_back();
    }
}

bool ProductNeighbourhood::take(const Coordinate* from, const Pattern& pattern, Coordinate* end,
                                Factor::Taken& taken) const
{
    std::copy_n(from, dimension_, end);
    taken = {0.0, false};
    for (std::size_t i = pattern.first; i < pattern.last; ++i)
    {
        const Part& part = parts_[i];
        const std::size_t first = firstCoordinate_[part.factor];
        Factor::Taken ofPart{};
        if (!factors_[part.factor]->take(from + first, part.step, end + first, ofPart))
            return false;
        taken.cost += ofPart.cost;
        taken.checked = taken.checked || ofPart.checked;
    }
    return true;
}

void ProductNeighbourhood::steps(const Coordinate* from, Steps& out) const
{
    if (out.steps.size() < patterns_.size())
        out.steps.resize(patterns_.size());
    if (out.ends.size() < patterns_.size() * dimension_)
        out.ends.resize(patterns_.size() * dimension_);
    out.count = 0;
    for (std::uint32_t index = 0; index < patterns_.size(); ++index)
    {
        Factor::Taken taken{};
        if (!take(from, patterns_[index], &out.ends[out.count * dimension_], taken))
            continue;
        out.steps[out.count++] = {taken.cost, index, 0, 0, taken.checked};
    }
}

bool ProductNeighbourhood::goOn(const Coordinate* from, const Coordinate* to, Coordinate* next) const
{
    Factor::Taken taken{};
    for (const Pattern& pattern : patterns_)
        if (take(from, pattern, next, taken) && std::equal(next, next + dimension_, to))
            return take(to, pattern, next, taken);
    return false;
}
}  // namespace specplan::lattice
