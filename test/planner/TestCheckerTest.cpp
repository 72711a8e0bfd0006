// SPDX-License-Identifier: BSD-3-Clause
// The test that users run on their own checkers: one checker with each fault, and some without.
#include <gtest/gtest.h>

#include <latch>
#include <map>
#include <sstream>
#include <thread>

#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "SpaceCases.h"
#include "specplan/planner/TestChecker.h"

namespace specplan::test
{
namespace
{
namespace ob = ompl::base;
using Kind = CheckerReport::Kind;

constexpr unsigned kThreads = 4;

/// A checker of a function.
class FunctionChecker : public ob::StateValidityChecker
{
public:
    using Function = std::function<bool(const double* xy)>;

    FunctionChecker(const ob::SpaceInformationPtr& si, Function function)
        : ob::StateValidityChecker(si), function_(std::move(function))
    {
    }

    bool isValid(const ob::State* state) const override
    {
        return function_(state->as<ob::RealVectorStateSpace::StateType>()->values);
    }

private:
    Function function_;
};

ob::SpaceInformationPtr square()
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0.0, 1.0);
    auto si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker([](const ob::State*) { return true; });
    si->setup();
    return si;
}

bool isInside(const double* xy)
{
    return xy[0] + xy[1] < 1.0;
}

CheckerTestOptions fewSamples()
{
    CheckerTestOptions options;
    options.samples = 100;
    options.threads = kThreads;
    return options;
}

CheckerReport tryChecker(FunctionChecker::Function function, const CheckerTestOptions& options = fewSamples())
{
    const ob::SpaceInformationPtr si = square();
    si->setStateValidityChecker(std::make_shared<FunctionChecker>(si, std::move(function)));
    return testChecker(si, options);
}

/// Slow calls are left out: on a busy machine any call may be one.
CheckerReport withoutSlow(CheckerReport report)
{
    std::erase_if(report.findings, [](const CheckerReport::Finding& finding) { return finding.kind == Kind::Slow; });
    return report;
}

/// The report has this finding and no other.
void expectOnly(const CheckerReport& all, Kind kind)
{
    const CheckerReport report = kind == Kind::Slow ? all : withoutSlow(all);
    ASSERT_EQ(report.findings.size(), 1U) << report;
    EXPECT_EQ(report.findings.front().kind, kind) << report;
    EXPECT_EQ(report.passed(), !CheckerReport::isError(kind));
}

/// A line of the report that contains all these words.
bool says(const CheckerReport& report, const std::vector<std::string>& words)
{
    return std::ranges::any_of(report.findings,
                               [&](const CheckerReport::Finding& finding)
                               {
                                   return std::ranges::all_of(words, [&](const std::string& word)
                                                              { return finding.text.find(word) != finding.text.npos; });
                               });
}

TEST(TestChecker, ACleanCheckerPassesAndEverythingIsCounted)
{
    std::atomic<std::size_t> calls{0};
    std::atomic<bool> outside{false};
    const CheckerReport report = tryChecker(
        [&](const double* xy)
        {
            ++calls;
            if (!(xy[0] >= 0.0 && xy[0] <= 1.0 && xy[1] >= 0.0 && xy[1] <= 1.0))
                outside = true;
            return isInside(xy);
        });
    EXPECT_TRUE(report.passed());
    EXPECT_TRUE(withoutSlow(report).findings.empty()) << report;
    EXPECT_FALSE(outside);
    EXPECT_EQ(report.states, 100U);
    EXPECT_EQ(report.calls, 100U * 3 * (1 + kThreads));
    EXPECT_EQ(report.calls, calls);
    EXPECT_EQ(report.threads, kThreads);
    EXPECT_GT(report.validStates, 10U);
    EXPECT_LT(report.validStates, 90U);
    std::ostringstream out;
    out << report;
    EXPECT_TRUE(out.str().starts_with("checker test: passed, 100 states, ")) << out.str();
}

TEST(TestChecker, EverySpaceGivesStatesInsideItsBounds)
{
    for (const SpaceCase& problem : spaceCases())
    {
        const auto si = std::make_shared<ob::SpaceInformation>(problem.make());
        std::atomic<bool> outside{false};
        si->setStateValidityChecker(
            [&](const ob::State* state)
            {
                if (!si->satisfiesBounds(state))
                    outside = true;
                return true;
            });
        const CheckerReport report = testChecker(si, fewSamples());
        EXPECT_TRUE(withoutSlow(report).findings.empty()) << problem.name << ": " << report;
        EXPECT_EQ(report.states, 100U) << problem.name;
        EXPECT_FALSE(outside) << problem.name;
    }
}

TEST(TestChecker, HalfOfTheStatesAreThoseOfALattice)
{
    std::map<double, int> columns;
    CheckerTestOptions options = fewSamples();
    options.threads = 1;
    options.samples = 400;
    (void)tryChecker(
        [&](const double* xy)
        {
            ++columns[xy[0]];
            return true;
        },
        options);
    // Uniform samples have a column each, states of a lattice share one.
    std::size_t shared = 0;
    for (const auto& [column, calls] : columns)
        if (calls > 6)
            shared += static_cast<std::size_t>(calls) / 6;
    EXPECT_GT(shared, 100U);
}

TEST(TestChecker, AnAnswerThatChangesIsNotDeterministic)
{
    std::atomic<unsigned> calls{0};
    const CheckerReport report = tryChecker([&](const double*) { return ++calls % 7 != 0; });
    expectOnly(report, Kind::NotDeterministic);
    EXPECT_TRUE(says(report, {"of 100 states got both answers from one thread", "(0."})) << report;
}

/// Answers seldom differ: only so many calls that one thread alone does not see it at first.
TEST(TestChecker, AnAnswerThatSeldomChangesIsNotBlamedOnThreads)
{
    std::atomic<unsigned> calls{0};
    const CheckerReport report = tryChecker([&](const double*) { return ++calls < 301 || calls % 2 == 0; });
    expectOnly(report, Kind::NotDeterministic);
    EXPECT_TRUE(says(report, {"and so does one thread now"})) << report;
}

TEST(TestChecker, AnAnswerThatChangesWithSeveralThreadsIsNotThreadSafe)
{
    const std::thread::id here = std::this_thread::get_id();
    std::atomic<int> inside{0};
    const CheckerReport report = tryChecker(
        [&](const double* xy)
        {
            if (++inside == 1 && std::this_thread::get_id() != here)
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            const bool disturbed = inside > 1;
            --inside;
            return isInside(xy) != disturbed;
        });
    expectOnly(report, Kind::NotThreadSafe);
    EXPECT_TRUE(says(report, {"not thread-safe", "states got other answers from 4 threads than from one"})) << report;
}

TEST(TestChecker, WritesIntoTheStateAreSeen)
{
    const CheckerReport report = tryChecker(
        [](const double* xy)
        {
            const bool valid = isInside(xy);
            const_cast<double*>(xy)[1] = 0.5;
            return valid;
        });
    expectOnly(report, Kind::WritesState);
    EXPECT_TRUE(says(report, {"writes into the state", "1500 times"})) << report;
}

/// A plane whose states carry a note, as those of a checker that remembers its answer in the state.
class NotedSpace : public ob::RealVectorStateSpace
{
public:
    class StateType : public ob::RealVectorStateSpace::StateType
    {
    public:
        unsigned char note = 0;
    };

    NotedSpace() : ob::RealVectorStateSpace(2)
    {
        setBounds(0.0, 1.0);
    }

    ob::State* allocState() const override
    {
        auto* state = new StateType();
        state->values = new double[2];
        return state;
    }

    void freeState(ob::State* state) const override
    {
        auto* noted = static_cast<StateType*>(state);
        delete[] noted->values;
        delete noted;
    }

    unsigned getSerializationLength() const override
    {
        return ob::RealVectorStateSpace::getSerializationLength() + 1;
    }

    void serialize(void* out, const ob::State* state) const override
    {
        auto* bytes = static_cast<unsigned char*>(out);
        ob::RealVectorStateSpace::serialize(bytes, state);
        bytes[getSerializationLength() - 1] = static_cast<const StateType*>(state)->note;
    }
};

TEST(TestChecker, ANoteInTheStateIsNoError)
{
    const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<NotedSpace>());
    si->setStateValidityChecker(
        [](const ob::State* state)
        {
            const_cast<ob::State*>(state)->as<NotedSpace::StateType>()->note = 1;
            return true;
        });
    const CheckerReport report = testChecker(si, fewSamples());
    expectOnly(report, Kind::WritesBesideValues);
    EXPECT_TRUE(says(report, {"1500 times", "this is no fault"})) << report;
}

TEST(TestChecker, ExceptionsAreReportedWithTheirMessages)
{
    const CheckerReport report = tryChecker(
        [](const double* xy)
        {
            if (xy[0] < 0.1)
                throw std::runtime_error("sensor lost");
            if (xy[0] > 0.9)
                throw 42;
            return true;
        });
    ASSERT_EQ(withoutSlow(report).findings.size(), 2U) << report;
    EXPECT_TRUE(report.has(Kind::Exception));
    EXPECT_FALSE(report.passed());
    EXPECT_TRUE(says(report, {"throws ", "times, at (0.0", ": sensor lost"})) << report;
    EXPECT_TRUE(says(report, {"at (0.9", "something that is not a std::exception"})) << report;
}

TEST(TestChecker, AnExceptionOfSeveralThreadsOnlyIsToldSo)
{
    const std::thread::id here = std::this_thread::get_id();
    const CheckerReport report = tryChecker(
        [here](const double*)
        {
            if (std::this_thread::get_id() != here)
                throw std::runtime_error("wrong thread");
            return true;
        });
    expectOnly(report, Kind::Exception);
    EXPECT_TRUE(says(report, {"with several threads only", "wrong thread"})) << report;
}

TEST(TestChecker, ASlowCallIsNamed)
{
    std::atomic<int> calls{0};
    const CheckerReport report = tryChecker(
        [&](const double*)
        {
            if (++calls == 50)
                std::this_thread::sleep_for(std::chrono::milliseconds(300));
            return true;
        });
    expectOnly(report, Kind::Slow);
    EXPECT_GE(report.slowestSeconds, 0.3);
    EXPECT_TRUE(says(report, {"one call took 0.", "(0."})) << report;
}

TEST(TestChecker, ATimeLimitLeavesStatesOut)
{
    CheckerTestOptions options = fewSamples();
    options.timeLimit = 0.2;
    const CheckerReport report = tryChecker(
        [](const double*)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            return true;
        },
        options);
    expectOnly(report, Kind::TimeLimit);
    EXPECT_GE(report.states, 1U);
    EXPECT_LT(report.states, 10U);
}

TEST(TestChecker, EachWorkersOwnCheckerIsUsedByOneThreadOnly)
{
    const ob::SpaceInformationPtr si = square();
    si->setStateValidityChecker([](const ob::State*) -> bool
                                { throw std::logic_error("the shared checker is not to be used"); });
    std::vector<std::atomic<int>> inside(kThreads);
    std::atomic<int> overlaps{0};
    const CheckerReport report = testChecker(si, fewSamples(),
                                             [&](const ob::SpaceInformationPtr& of, unsigned worker)
                                             {
                                                 return std::make_shared<FunctionChecker>(of,
                                                                                          [&, worker](const double* xy)
                                                                                          {
                                                                                              if (++inside[worker] > 1)
                                                                                                  ++overlaps;
                                                                                              const bool valid =
                                                                                                  isInside(xy);
                                                                                              --inside[worker];
                                                                                              return valid;
                                                                                          });
                                             });
    EXPECT_TRUE(withoutSlow(report).findings.empty()) << report;
    EXPECT_EQ(overlaps, 0);
    EXPECT_EQ(report.calls, 100U * 3 * (1 + kThreads) + 100U);
}

TEST(TestChecker, AnAllocatorThatGivesOneCheckerToSeveralWorkersIsReported)
{
    const ob::SpaceInformationPtr si = square();
    const auto shared = std::make_shared<FunctionChecker>(si, isInside);
    const CheckerReport report =
        testChecker(si, fewSamples(), [&](const ob::SpaceInformationPtr&, unsigned) { return shared; });
    expectOnly(report, Kind::SharedChecker);
    EXPECT_TRUE(says(report, {"1 different checkers for 4 workers"})) << report;
}

TEST(TestChecker, CheckersOfWorkersThatDoNotAgreeAreReported)
{
    const ob::SpaceInformationPtr si = square();
    const CheckerReport report =
        testChecker(si, fewSamples(),
                    [](const ob::SpaceInformationPtr& of, unsigned worker)
                    {
                        return std::make_shared<FunctionChecker>(
                            of, [worker](const double* xy) { return isInside(xy) == (worker != 2); });
                    });
    EXPECT_TRUE(says(report, {"checkers of two workers do not agree on 25 of 100"})) << report;
}

TEST(TestChecker, CheckersOfWorkersThatDisturbEachOtherAreReported)
{
    const ob::SpaceInformationPtr si = square();
    const std::thread::id here = std::this_thread::get_id();
    const CheckerReport report = testChecker(
        si, fewSamples(),
        [here](const ob::SpaceInformationPtr& of, unsigned)
        {
            return std::make_shared<FunctionChecker>(
                of, [here](const double* xy) { return isInside(xy) == (std::this_thread::get_id() == here); });
        });
    expectOnly(report, Kind::NotThreadSafe);
    EXPECT_TRUE(says(report, {"checkers of different workers disturb each other"})) << report;
}

/// Takes what the library tells the user, and gives it to a function.
class Listener : public ompl::msg::OutputHandler
{
public:
    explicit Listener(std::function<void(const std::string&)> listen) : listen_(std::move(listen))
    {
        ompl::msg::useOutputHandler(this);
    }

    ~Listener() override
    {
        ompl::msg::restorePreviousOutputHandler();
    }

    void log(const std::string& text, ompl::msg::LogLevel, const char*, int) override
    {
        listen_(text);
    }

private:
    std::function<void(const std::string&)> listen_;
};

/// The checker is locked until the warning comes.
TEST(TestChecker, ACheckerThatDoesNotComeBackIsNamedWhileItHangs)
{
    std::latch warned(1);
    std::string warning;
    const Listener listener(
        [&](const std::string& text)
        {
            if (text.find("no check has come back") == text.npos)
                return;
            warning = text;
            warned.count_down();
        });
    const std::thread::id here = std::this_thread::get_id();
    CheckerTestOptions options = fewSamples();
    options.patience = 0.05;
    const CheckerReport report = tryChecker(
        [&](const double*)
        {
            if (std::this_thread::get_id() != here)
                warned.wait();
            return true;
        },
        options);
    EXPECT_NE(warning.find("is the checker locked? It is asked for the state (0."), warning.npos) << warning;
    EXPECT_TRUE(report.passed()) << report;
}

TEST(TestChecker, WhatCannotBeTestedIsRefused)
{
    const ob::SpaceInformationPtr si = square();
    EXPECT_THROW((void)testChecker(nullptr), std::invalid_argument);
    const auto refuses = [&si](const std::function<void(CheckerTestOptions&)>& change, const std::string& what)
    {
        CheckerTestOptions options = fewSamples();
        change(options);
        try
        {
            (void)testChecker(si, options);
            ADD_FAILURE() << what;
        }
        catch (const std::invalid_argument& error)
        {
            EXPECT_EQ(std::string(error.what()).rfind("testChecker: " + what, 0), 0U) << error.what();
        }
    };
    refuses([](CheckerTestOptions& options) { options.samples = 0; }, "samples must be 1 or more");
    refuses([](CheckerTestOptions& options) { options.threads = 0; }, "threads must be between 1 and 4096");
    refuses([](CheckerTestOptions& options) { options.threads = 5000; }, "threads must be between 1 and 4096");
    refuses([](CheckerTestOptions& options) { options.rounds = 0; }, "rounds must be 1 or more");
    refuses([](CheckerTestOptions& options) { options.timeLimit = 0.0; }, "timeLimit must be");
    refuses([](CheckerTestOptions& options) { options.timeLimit = std::nan(""); }, "timeLimit must be");
    refuses([](CheckerTestOptions& options) { options.patience = 0.0; }, "patience must be");

    const auto bare = std::make_shared<ob::SpaceInformation>(si->getStateSpace());
    try
    {
        (void)testChecker(bare);
        ADD_FAILURE() << "not refused";
    }
    catch (const ompl::Exception& error)
    {
        EXPECT_STREQ(error.what(), "testChecker: the space information has no state validity checker");
    }
    EXPECT_THROW(
        (void)testChecker(si, fewSamples(),
                          [](const ob::SpaceInformationPtr&, unsigned) { return ob::StateValidityCheckerPtr(); }),
        ompl::Exception);
}
}  // namespace
}  // namespace specplan::test
