// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: part of the planner's public face.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace specplan
{
/// What testChecker() has found.
struct CheckerReport
{
    enum class Kind
    {
        NotDeterministic,    ///< equal states got different answers from one thread
        NotThreadSafe,       ///< answers differ, but only with several threads
        Exception,           ///< a call threw
        WritesState,         ///< the values of a state were changed by the call
        WritesBesideValues,  ///< something else was changed in the state, such as a cached answer; a note
        SharedChecker,       ///< the allocator gave several workers the same checker
        Slow,                ///< one call took far longer than most; a note
        TimeLimit            ///< the time was up before all calls were made; a note
    };

    /// One line for the user.
    struct Finding
    {
        Kind kind;
        std::string text;
    };

    std::vector<Finding> findings;
    std::size_t states = 0;       ///< different states that were checked
    std::size_t validStates = 0;  ///< of these, valid at the first call
    std::size_t calls = 0;        ///< of isValid()
    unsigned threads = 1;         ///< that called at once
    double medianSeconds = 0.0;   ///< of a call, one thread
    double slowestSeconds = 0.0;  ///< of a call, one thread

    /// Whether this is a defect; otherwise it is a note.
    [[nodiscard]] static bool isError(Kind kind) noexcept;

    /// Whether there is no defect among the findings.
    [[nodiscard]] bool passed() const noexcept;

    /// Whether there is a finding of this kind.
    [[nodiscard]] bool has(Kind kind) const noexcept;
};

/// One line of counts, then one for each finding.
std::ostream& operator<<(std::ostream& out, const CheckerReport& report);
}  // namespace specplan
