// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <string>

namespace specplan::test
{
/// Counts the expectations that were not met.
class MismatchCounter : public testing::EmptyTestEventListener
{
public:
    void OnTestPartResult(const testing::TestPartResult& result) override
    {
        mismatches += result.failed() ? 1 : 0;
    }

    std::uint64_t mismatches = 0;
};

/// One run of a soak program, "PROGRAM SECONDS SEED": rounds with a new seed each until the time is over. At the end it
/// prints what was done and what went wrong, one "count NAME NUMBER" a line, which scripts/soak adds up.
class SoakRun
{
public:
    SoakRun(int argc, char** argv)
    {
        testing::InitGoogleTest(&argc, argv);
        isUsable_ = argc == 3 && parse(argv[1], seconds_) && parse(argv[2], seed_);
        if (!isUsable_)
        {
            std::cerr << "usage: " << argv[0] << " SECONDS SEED\n";
            return;
        }
        testing::UnitTest::GetInstance()->listeners().Append(counter_);
        end_ = std::chrono::steady_clock::now() + std::chrono::seconds(seconds_);
    }

    [[nodiscard]] bool isUsable() const noexcept
    {
        return isUsable_;
    }

    /// Goes on to the next round. \return false if the time is over, but never before the first one.
    bool nextRound()
    {
        ++seed_;
        return rounds_++ == 0 || std::chrono::steady_clock::now() < end_;
    }

    [[nodiscard]] std::uint64_t seed() const noexcept
    {
        return seed_;
    }

    std::uint64_t problems = 0;
    std::uint64_t checks = 0;
    std::uint64_t faults = 0;
    std::uint64_t planners = 0;
    std::uint64_t leaks = 0;  ///< states that were not freed, files that were not closed, rounds of growing memory
    std::uint64_t threadsLeft = 0;  ///< threads that outlived their planners

    /// \return exit status: 0 if nothing went wrong.
    [[nodiscard]] int finish() const
    {
        std::cout << "count problems " << problems << "\ncount checks " << checks << "\ncount faults " << faults
                  << "\ncount planners " << planners << "\ncount mismatches " << counter_->mismatches
                  << "\ncount leaks " << leaks << "\ncount threads_left " << threadsLeft << '\n';
        return counter_->mismatches + leaks + threadsLeft == 0 ? 0 : 1;
    }

private:
    static bool parse(const std::string& text, std::uint64_t& number)
    {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        return error == std::errc{} && end == text.data() + text.size();
    }

    bool isUsable_ = false;
    std::uint64_t seconds_ = 0;
    std::uint64_t seed_ = 0;
    std::uint64_t rounds_ = 0;
    std::chrono::steady_clock::time_point end_;
    MismatchCounter* counter_ = new MismatchCounter;  // googletest takes it
};
}  // namespace specplan::test
