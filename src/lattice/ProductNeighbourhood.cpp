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
    addCombinations(0, connectivity, parts);
    addPatterns();
}

/// Enters every choice of steps of the factors from `factor` on, beside the parts chosen so far.
void ProductNeighbourhood::addCombinations(std::size_t factor, unsigned axesLeft, std::vector<Part>& parts)
{
    if (factor == factors_.size())
    {
        if (parts.empty())
            return;
        if (combinations_.size() == kMaxSteps)
            throw std::invalid_argument("a node has more than 65536 neighbours; choose a smaller connectivity");
        combinations_.push_back({parts_.size(), parts_.size() + parts.size()});
        parts_.insert(parts_.end(), parts.begin(), parts.end());
        return;
    }
    addCombinations(factor + 1, axesLeft, parts);
    for (std::uint32_t step = 0; step < factors_[factor]->steps(); ++step)
    {
        const unsigned axes = factors_[factor]->axes(step);
        // A factor's own steps are its own affair; only together with others they have to share.
        if (!parts.empty() && axes > axesLeft)
            continue;
        parts.push_back({static_cast<std::uint32_t>(factor), step});
        addCombinations(factor + 1, axes < axesLeft ? axesLeft - axes : 0, parts);
        parts.pop_back();
    }
}

void ProductNeighbourhood::addPatterns()
{
    for (const Combination& combination : combinations_)
    {
        Pattern pattern{0.0, false, {}};
        for (std::size_t i = combination.first; i < combination.last; ++i)
        {
            const std::optional<Factor::Taken> taken = factors_[parts_[i].factor]->always(parts_[i].step);
            if (!taken)
            {
                patterns_.clear();
                return;
            }
            pattern.cost += taken->cost;
            pattern.motionCheck = pattern.motionCheck || taken->checked;
        }
        patterns_.push_back(std::move(pattern));
    }
}

bool ProductNeighbourhood::take(const Coordinate* from, const Combination& combination, Coordinate* end,
                                Factor::Taken& taken) const
{
    std::copy_n(from, dimension_, end);
    taken = {0.0, false};
    for (std::size_t i = combination.first; i < combination.last; ++i)
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
    if (out.steps.size() < combinations_.size())
        out.steps.resize(combinations_.size());
    if (out.ends.size() < combinations_.size() * dimension_)
        out.ends.resize(combinations_.size() * dimension_);
    out.count = 0;
    for (std::uint32_t index = 0; index < combinations_.size(); ++index)
    {
        Factor::Taken taken{};
        if (!take(from, combinations_[index], &out.ends[out.count * dimension_], taken))
            continue;
        out.steps[out.count++] = {taken.cost, index, taken.checked};
    }
}

bool ProductNeighbourhood::goOn(const Coordinate* from, const Coordinate* to, Coordinate* next) const
{
    Factor::Taken taken{};
    for (const Combination& combination : combinations_)
        if (take(from, combination, next, taken) && std::equal(next, next + dimension_, to))
            return take(to, combination, next, taken);
    return false;
}
}  // namespace specplan::lattice
