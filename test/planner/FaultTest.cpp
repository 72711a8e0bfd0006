// SPDX-License-Identifier: BSD-3-Clause
// What the planner keeps of its promises when the user's code fails.
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "FaultRun.h"
#include "ProcessCounts.h"

namespace specplan::test
{
namespace
{
constexpr std::uint64_t kSeed = 11;

struct Case
{
    Place place;
    Fault fault;
    unsigned threads;
    std::string evaluation;

    friend void PrintTo(const Case& of, std::ostream* out)
    {
        *out << nameOf(of.place) << ' ' << nameOf(of.fault) << ", " << of.threads << " threads, " << of.evaluation;
    }
};

class FaultTest : public testing::TestWithParam<Case>
{
};

/// Made once for each.
const SearchReport& clean(Place place, const std::string& evaluation)
{
    static std::map<std::pair<Place, std::string>, SearchReport> reports;
    const auto [found, isNew] = reports.try_emplace({place, evaluation});
    if (isNew)
    {
        found->second = cleanReport(place, evaluation, 0);
        EXPECT_EQ(found->second.status, "solved");
    }
    return found->second;
}

TEST_P(FaultTest, LeavesNothingBehindAndTheNextSolveWorks)
{
    const auto& [place, fault, threads, evaluation] = GetParam();
    const SearchReport& expected = clean(place, evaluation);
    const ProcessCounts before = ProcessCounts::now();
    const std::int64_t statesBefore = FaultyProblem::livingStates();
    FaultRun(place, fault, kSeed, 0).run(threads, evaluation, expected);
    EXPECT_EQ(FaultyProblem::livingStates(), statesBefore);
    EXPECT_EQ(ProcessCounts::now().threads, before.threads);
    EXPECT_EQ(ProcessCounts::now().files, before.files);
}

std::vector<Case> cases()
{
    std::vector<Case> all;
    for (const Place place : kPlaces)
        for (const Fault fault : kFaults)
            for (const unsigned threads : {1U, 2U, 8U})
                for (const char* evaluation : {"eager", "lazy"})
                    all.push_back({place, fault, threads, evaluation});
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, FaultTest, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& of)
                         {
                             return std::string(nameOf(of.param.place)) + nameOf(of.param.fault) +
                                    std::to_string(of.param.threads) + of.param.evaluation;
                         });

/// Wherever an exception hits, no start, goal or verdict is lost: the next solve() ends as if nothing had happened.
TEST(Faults, AfterACrashTheNextSolveIsRightWhicheverCallFailed)
{
    for (const Place place : kPlaces)
        for (const char* evaluation : {"eager", "lazy"})
            for (std::uint64_t call = 1; call <= 120; ++call)
            {
                SCOPED_TRACE(std::string(nameOf(place)) + ' ' + evaluation + ", call " + std::to_string(call));
                FaultyProblem problem(place, Fault::Throws, kSeed, 0);
                problem.code.failOnly(call);
                problem.makePlanner(1, evaluation);
                const ob::PlannerStatus first = problem.solve();
                ASSERT_EQ(first == ob::PlannerStatus::CRASH, problem.code.injected() > 0) << first.asString();
                if (first != ob::PlannerStatus::CRASH)
                    break;  // there are not so many calls
                ASSERT_EQ(problem.solve(), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_EQ(problem.planner->getReport().cost, clean(place, evaluation).cost);
                EXPECT_TRUE(problem.path().check());
            }
}

/// The faults do happen; otherwise all of the above would say nothing.
TEST(Faults, AreInjectedInEveryPlace)
{
    for (const Place place : kPlaces)
        for (const Fault fault : kFaults)
        {
            const bool needsState = fault == Fault::Writes || fault == Fault::CallsBack;
            const bool tellsNoState = place == Place::Space || place == Place::Termination;
            FaultyProblem problem(place, fault, kSeed, 0);
            problem.makePlanner(2, "eager");
            (void)problem.solve();
            EXPECT_GT(problem.code.calls(), 0U) << nameOf(place);
            EXPECT_EQ(problem.code.injected() > 0, fault != Fault::None && !(needsState && tellsNoState))
                << nameOf(place) << ' ' << nameOf(fault);
        }
}
}  // namespace
}  // namespace specplan::test
