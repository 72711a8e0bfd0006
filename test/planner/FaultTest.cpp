// SPDX-License-Identifier: BSD-3-Clause
// What the planner keeps of its promises when the user's code fails.
#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "FaultyProblem.h"
#include "ProcessCounts.h"
#include "specplan/planner/OmplCompat.h"

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

/// What a search without faults finds.
const SearchReport& cleanReport(Place place, const std::string& evaluation)
{
    static std::map<std::pair<Place, std::string>, SearchReport> reports;
    const auto [found, isNew] = reports.try_emplace({place, evaluation});
    if (isNew)
    {
        FaultyProblem problem(place, Fault::None, kSeed);
        problem.makePlanner(1, evaluation);
        EXPECT_EQ(problem.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        found->second = problem.planner->getReport();
    }
    return found->second;
}

void expectMessage(const SearchReport& report, Fault fault)
{
    if (fault == Fault::Throws)
        EXPECT_EQ(report.error, FaultyCode::kMessage);
    else if (fault == Fault::ThrowsOther)
        EXPECT_EQ(report.error, "a check threw something that is not a std::exception");
    else if (fault == Fault::RunsOutOfMemory)
        EXPECT_EQ(report.error, "std::bad_alloc");
    else
        ADD_FAILURE() << "a crash without reason: " << report.error;
}

/// The status of a search with faults is one that tells what has happened.
void expectDefined(ob::PlannerStatus status, const SearchReport& report, Fault fault)
{
    if (status == ob::PlannerStatus::CRASH)
    {
        EXPECT_EQ(report.status, "crash");
        expectMessage(report, fault);
        return;
    }
    EXPECT_EQ(report.error, "");
    if (status == ob::PlannerStatus::EXACT_SOLUTION)
        EXPECT_EQ(report.status, "solved");
    else if (fault == Fault::Lies && status == planner::kInfeasible)
        EXPECT_EQ(report.status, "infeasible");
    else
        ADD_FAILURE() << status.asString() << ", " << report.status;
}

void expectClean(const FaultyProblem& problem, const SearchReport& clean)
{
    const SearchReport& report = problem.planner->getReport();
    EXPECT_EQ(report.status, "solved");
    EXPECT_EQ(report.error, "");
    EXPECT_EQ(report.orderHash, clean.orderHash);
    EXPECT_EQ(report.cost, clean.cost);
    ASSERT_TRUE(problem.pdef->hasExactSolution());
    EXPECT_TRUE(problem.path().check());
}

TEST_P(FaultTest, LeavesNothingBehindAndTheNextSolveWorks)
{
    const auto& [place, fault, threads, evaluation] = GetParam();
    const SearchReport& clean = cleanReport(place, evaluation);
    const ProcessCounts before = ProcessCounts::now();
    const std::int64_t statesBefore = FaultyProblem::livingStates();
    {
        FaultyProblem problem(place, fault, kSeed);
        problem.makePlanner(threads, evaluation);
        ob::PlannerStatus status;
        for (int attempt = 0; attempt < 3; ++attempt)
        {
            status = problem.solve();
            const std::uint64_t calls = problem.code.calls();
            expectDefined(status, problem.planner->getReport(), fault);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            EXPECT_EQ(problem.code.calls(), calls) << "the user's code ran after solve() had returned";
        }
        if (isHarmless(fault))
            expectClean(problem, clean);

        problem.code.mend();
        problem.planner->clear();
        problem.pdef->clearSolutionPaths();
        ASSERT_EQ(problem.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        expectClean(problem, clean);
    }
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

/// The faults do happen; otherwise all of the above would say nothing.
TEST(Faults, AreInjectedInEveryPlace)
{
    for (const Place place : kPlaces)
        for (const Fault fault : kFaults)
        {
            const bool needsState = fault == Fault::Writes || fault == Fault::CallsBack;
            const bool tellsNoState = place == Place::Space || place == Place::Termination;
            FaultyProblem problem(place, fault, kSeed);
            problem.makePlanner(2, "eager");
            (void)problem.solve();
            EXPECT_GT(problem.code.calls(), 0U) << nameOf(place);
            EXPECT_EQ(problem.code.injected() > 0, fault != Fault::None && !(needsState && tellsNoState))
                << nameOf(place) << ' ' << nameOf(fault);
        }
}
}  // namespace
}  // namespace specplan::test
