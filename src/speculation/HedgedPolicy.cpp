// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/speculation/HedgedPolicy.h"

#include <algorithm>

namespace specplan::speculation
{
using lattice::CheckId;

namespace
{
/// What is less likely to be valid than this the wary shadow takes for invalid.
constexpr double kDoubtful = 0.7;
constexpr double kHardlyPossible = 1e-3;

/// Up to so many workers one shadow is right often enough.
constexpr unsigned kFewWorkers = 8;
}  // namespace

HedgedPolicy::HedgedPolicy(lattice::Lattice& lattice, const validity::Broker& broker, const FrontierView& frontier,
                           Predictor& predictor, double weight)
    : waryPredictor_(predictor),
      likely_(lattice, broker, frontier, predictor, weight),
      wary_(lattice, broker, frontier, waryPredictor_, weight)
{
}

double HedgedPolicy::WaryPredictor::probabilityValid(lattice::NodeId node) const
{
    const double probability = predictor_.probabilityValid(node);
    return probability < kDoubtful ? kHardlyPossible : probability;
}

void HedgedPolicy::expanding(lattice::NodeId node, lattice::NodeId parent)
{
    likely_.expanding(node, parent);
    wary_.expanding(node, parent);
}

void HedgedPolicy::propose(std::size_t count, std::vector<CheckId>& out)
{
    for (; count > 0; --count)
    {
        RunAheadPolicy& first = waryNext_ ? wary_ : likely_;
        RunAheadPolicy& second = waryNext_ ? likely_ : wary_;
        waryNext_ = !waryNext_;
        if (!proposeOne(first, out) && !proposeOne(second, out))
            return;
    }
}

/// \return false if the shadow knows nothing that is not in `out` already.
bool HedgedPolicy::proposeOne(Policy& shadow, std::vector<CheckId>& out)
{
    for (;;)
    {
        one_.clear();
        shadow.propose(1, one_);
        if (one_.empty())
            return false;
        if (std::ranges::find(out, one_.front()) != out.end())
            continue;
        out.push_back(one_.front());
        return true;
    }
}

void HedgedPolicy::learned(CheckId check, bool valid)
{
    likely_.learned(check, valid);  // first: it tells the predictor
    wary_.learned(check, valid);
}

void HedgedPolicy::missed()
{
    likely_.missed();
    wary_.missed();
}

bool HedgedPolicy::stillWanted(CheckId check) const
{
    return likely_.stillWanted(check) || wary_.stillWanted(check);
}

std::unique_ptr<Policy> makeRunAhead(lattice::Lattice& lattice, const validity::Broker& broker,
                                     const FrontierView& frontier, Predictor& predictor, double weight,
                                     unsigned workers)
{
    if (weight > 1.0 && workers > kFewWorkers)
        return std::make_unique<HedgedPolicy>(lattice, broker, frontier, predictor, weight);
    return std::make_unique<RunAheadPolicy>(lattice, broker, frontier, predictor, weight);
}
}  // namespace specplan::speculation
