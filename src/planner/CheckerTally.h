// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace specplan::planner
{
/// What one thread saw while it tried a checker; states go by their numbers.
struct CheckerTally
{
    struct Answers
    {
        unsigned valid = 0;
        unsigned invalid = 0;
    };

    /// Something that happened once or more often, and the state of the first time.
    struct Event
    {
        std::size_t count = 0;
        std::size_t state = 0;

        void add(std::size_t atState) noexcept
        {
            if (count++ == 0)
                state = atState;
        }
    };

    explicit CheckerTally(std::size_t states) : answers(states)
    {
    }

    void merge(const CheckerTally& other);

    std::vector<Answers> answers;             ///< of each state
    std::map<std::string, Event> exceptions;  ///< by message
    Event valuesWritten;
    Event restWritten;
    std::vector<double> seconds;  ///< of each call that returned or threw
    std::size_t slowest = 0;      ///< state of the slowest call
    double slowestSeconds = -1.0;
};
}  // namespace specplan::planner
