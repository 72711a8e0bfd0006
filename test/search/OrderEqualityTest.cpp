// SPDX-License-Identifier: BSD-3-Clause
// The master test: speculation is invisible, see OrderEquality.h.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "OrderEquality.h"

namespace specplan::test
{
namespace
{
TEST(OrderEquality, EveryExecutorPolicyAndThreadCountMatchesTheSerialReference)
{
    std::vector<Configuration> configurations = allConfigurations();
    std::map<std::string, std::uint64_t> problems;  // solved by each configuration
    std::uint64_t solved = 0;
    for (std::uint64_t seed = 1; seed <= problemCount(); ++seed)
    {
        const RandomProblem problem(seed, static_cast<CostsBefore>(seed % 3));
        const CellSolution reference = referenceAStar(problem.forReference());
        solved += reference.path.empty() ? 0 : 1;
        for (Configuration* configuration : configurationsFor(seed, configurations))
        {
            SCOPED_TRACE("problem " + std::to_string(seed) + ", " + configuration->name);
            (void)expectSameSearch(problem, reference, *configuration->checker, *configuration);
            ++problems[configuration->name];
            if (HasFatalFailure() || HasNonfatalFailure())
                return;
        }
    }
    // The problems are a mixture, or the test would show little.
    EXPECT_GT(solved, problemCount() / 4);
    EXPECT_LT(solved, problemCount());
    for (const Configuration& configuration : configurations)
        EXPECT_GE(problems[configuration.name], problemCount() / 15) << configuration.name;
}

/// Counts what it passes on.
class MotionCounter : public validity::Checker
{
public:
    explicit MotionCounter(ProblemChecker& checker) : checker_(checker)
    {
    }

    bool check(CheckId check, unsigned worker) override
    {
        motions += check.isMotion() ? 1 : 0;
        return checker_.check(check, worker);
    }

    std::uint64_t motions = 0;

private:
    ProblemChecker& checker_;
};

TEST(OrderEquality, FewerMotionsAreCheckedThanTheReferenceMeets)
{
    ProblemChecker checker(1, false);
    std::uint64_t checked = 0;
    std::uint64_t met = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        SCOPED_TRACE("problem " + std::to_string(seed));
        const RandomProblem problem(seed);
        CellProblem plain = problem.forReference();
        std::uint64_t metHere = 0;
        plain.isMotionValid = [&metHere, isValid = plain.isMotionValid](const Cell& from, const Cell& to)
        {
            ++metHere;
            return isValid(from, to);
        };
        const CellSolution reference = referenceAStar(plain);
        MotionCounter counter(checker);
        Configuration sequential{"inline", "none", false, nullptr, std::make_unique<validity::InlineExecutor>(counter)};
        (void)expectSameSearch(problem, reference, checker, sequential);
        EXPECT_LE(counter.motions, metHere);
        checked += counter.motions;
        met += counter.motions > 0 ? metHere : 0;
    }
    EXPECT_GT(checked, 0U);
    EXPECT_LT(static_cast<double>(checked), 0.7 * static_cast<double>(met));
}
}  // namespace
}  // namespace specplan::test
