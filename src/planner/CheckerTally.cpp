// SPDX-License-Identifier: BSD-3-Clause
#include "CheckerTally.h"

namespace specplan::planner
{
namespace
{
void merge(CheckerTally::Event& event, const CheckerTally::Event& other)
{
    if (event.count == 0)
        event.state = other.state;
    event.count += other.count;
}
}  // namespace

void CheckerTally::merge(const CheckerTally& other)
{
    for (std::size_t state = 0; state < answers.size(); ++state)
    {
        answers[state].valid += other.answers[state].valid;
        answers[state].invalid += other.answers[state].invalid;
    }
    for (const auto& [message, event] : other.exceptions)
        planner::merge(exceptions[message], event);
    planner::merge(valuesWritten, other.valuesWritten);
    planner::merge(restWritten, other.restWritten);
    seconds.insert(seconds.end(), other.seconds.begin(), other.seconds.end());
    if (other.slowestSeconds > slowestSeconds)
    {
        slowest = other.slowest;
        slowestSeconds = other.slowestSeconds;
    }
}
}  // namespace specplan::planner
