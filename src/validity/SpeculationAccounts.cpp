// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/SpeculationAccounts.h"

#include <algorithm>

namespace specplan::validity
{
namespace
{
/// Seconds of thinking and handing over after which a balance is drawn.
constexpr double kTrial = 0.002;
/// They may take this much time for a second of checks that they brought to other threads, and for a second of all
/// checks so far: now and then the source has to think for long, to grow or to begin anew.
constexpr double kMostThinking = 0.8;
constexpr double kMostSpike = 0.01;
/// How much longer each further rest in vain is, and the most.
constexpr double kLongerRest = 2.0;
constexpr double kMostRest = 1000.0;
}  // namespace

void SpeculationAccounts::addGain(double seconds, bool thoughtOf, double times) noexcept
{
    const double gain = times * (seconds - kHandOver / kMostThinking);
    gain_ += gain;
    thoughtGain_ += thoughtOf ? gain : 0.0;
}

bool SpeculationAccounts::settle(double runSeconds) noexcept
{
    const double spent = thought_ + handOver_;
    if (spent <= kTrial)
        return false;
    const double inVain = std::max(thought_ - kMostThinking * thoughtGain_, spent - kMostThinking * gain_);
    const bool tooMuch = inVain > kMostSpike * runSeconds;
    if (tooMuch)
    {
        restsUntil_ = executor_.now() + nextRest_ * spent;
        handOverIsDear_ = handOver_ > kMostThinking * gain_;
        nextRest_ = std::min(nextRest_ * kLongerRest, kMostRest);
        beginsAnew_ = true;
    }
    else if (inVain > 0.0)
        return false;
    else
        nextRest_ = kRest;
    thought_ = handOver_ = thoughtGain_ = gain_ = 0.0;
    return tooMuch;
}
}  // namespace specplan::validity
