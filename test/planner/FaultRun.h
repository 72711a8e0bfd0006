// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "FaultyProblem.h"
#include "specplan/planner/OmplCompat.h"

namespace specplan::test
{
/// One search with one fault, and what has to hold then: the status tells what has happened, nothing runs on, harmless
/// faults change nothing, and once the fault is mended everything is as if there had been none.
class FaultRun
{
public:
    FaultRun(Place place, Fault fault, std::uint64_t seed, std::uint64_t scene)
        : fault_(fault), problem_(place, fault, seed, scene)
    {
    }

    /// \param clean what a search without faults finds.
    void run(unsigned threads, const std::string& evaluation, const SearchReport& clean)
    {
        problem_.makePlanner(threads, evaluation);
        for (int attempt = 0; attempt < 3; ++attempt)
        {
            expectDefined(problem_.solve());
            const std::uint64_t calls = problem_.code.calls();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            EXPECT_EQ(problem_.code.calls(), calls) << "the user's code ran after solve() had returned";
        }
        if (isHarmless(fault_))
            expectClean(clean);

        problem_.code.mend();
        problem_.planner->clear();
        problem_.pdef->clearSolutionPaths();
        (void)problem_.solve();
        expectClean(clean);
    }

    [[nodiscard]] const FaultyCode& code() const noexcept
    {
        return problem_.code;
    }

private:
    void expectDefined(ob::PlannerStatus status)
    {
        const SearchReport& report = problem_.planner->getReport();
        if (status == ob::PlannerStatus::CRASH)
        {
            EXPECT_EQ(report.status, "crash");
            expectMessage(report.error);
            return;
        }
        EXPECT_EQ(report.error, "");
        EXPECT_TRUE((status == ob::PlannerStatus::EXACT_SOLUTION && report.status == "solved") ||
                    (status == planner::kInfeasible && report.status == "infeasible"))
            << status.asString() << ", " << report.status;
    }

    void expectMessage(const std::string& error) const
    {
        // A path whose check says something else than the search was told is not called exact.
        const std::map<Fault, std::string> expected{
            {Fault::Throws, FaultyCode::kMessage},
            {Fault::ThrowsOther, "a check threw something that is not a std::exception"},
            {Fault::RunsOutOfMemory, "std::bad_alloc"},
            {Fault::Lies, "though the search found it valid"}};
        const auto found = expected.find(fault_);
        EXPECT_TRUE(found != expected.end() && error.find(found->second) != error.npos) << error;
    }

    void expectClean(const SearchReport& clean) const
    {
        const SearchReport& report = problem_.planner->getReport();
        EXPECT_EQ(report.status, clean.status);
        EXPECT_EQ(report.error, "");
        EXPECT_EQ(report.orderHash, clean.orderHash);
        EXPECT_EQ(problem_.pdef->hasExactSolution(), clean.status == "solved");
        if (!problem_.pdef->hasExactSolution())
            return;
        EXPECT_EQ(report.cost, clean.cost);
        EXPECT_TRUE(problem_.path().check());
    }

    Fault fault_;
    FaultyProblem problem_;
};

/// What a search without faults finds.
inline SearchReport cleanReport(Place place, const std::string& evaluation, std::uint64_t scene)
{
    FaultyProblem problem(place, Fault::None, 0, scene);
    problem.makePlanner(1, evaluation);
    const ob::PlannerStatus status = problem.solve();
    EXPECT_TRUE(status == ob::PlannerStatus::EXACT_SOLUTION || status == planner::kInfeasible) << status.asString();
    return problem.planner->getReport();
}
}  // namespace specplan::test
