// SPDX-License-Identifier: BSD-3-Clause
#include "CheckerTest.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "StateContents.h"
#include "TestStates.h"
#include "specplan/validity/RunCheck.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
// Shares of the time limit. States that are not checked by the end of the first round are left out.
constexpr double kFirstRound = 0.2;
constexpr double kOneThread = 0.5;
constexpr double kAll = 1.0;

constexpr double kSlowTimes = 100.0;  // as the median
constexpr double kSlowSeconds = 0.1;  // less may be due to a busy machine

template <typename... Parts>
std::string concat(const Parts&... parts)
{
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

std::string times(std::size_t count)
{
    return count == 1 ? "once" : concat(count, " times");
}

/// Joins all that were started, whatever happens.
class Threads
{
public:
    ~Threads()
    {
        mayStart = true;
        mayStart.notify_all();
        for (std::thread& thread : all)
            thread.join();
    }

    std::atomic<bool> mayStart{false};
    std::vector<std::thread> all;
};
}  // namespace

CheckerTest::CheckerTest(ob::SpaceInformationPtr si, const CheckerTestOptions& options,
                         const SpeculativeAStar::StateValidityCheckerAllocator& allocator)
    : si_(std::move(si)),
      options_(options),
      start_(validity::steadySeconds()),
      states_(makeTestStates(*si_, options.samples, options.seed)),
      watch_(options.threads, options.patience,
             [this](std::size_t state)
             {
                 OMPL_WARN(
                     "testChecker: no check has come back for %g s; is the checker locked? It is asked for the "
                     "state %s",
                     options_.patience, at(state).c_str());
             }),
      oneThread_(states_.size()),
      oneByOne_(states_.size()),
      threads_(states_.size())
{
    makeCheckers(allocator);
}

void CheckerTest::makeCheckers(const SpeculativeAStar::StateValidityCheckerAllocator& allocator)
{
    if (!allocator)
        checkers_.push_back(si_->getStateValidityChecker());
    else
        for (unsigned worker = 0; worker < options_.threads; ++worker)
            checkers_.push_back(allocator(si_, worker));
    if (std::ranges::any_of(checkers_, [](const auto& checker) { return checker == nullptr; }))
        throw ompl::Exception(allocator ? "testChecker: the state validity checker allocator returned nothing"
                                        : "testChecker: the space information has no state validity checker");
    const std::set<ob::StateValidityCheckerPtr> different(checkers_.begin(), checkers_.end());
    if (different.size() < checkers_.size())
        find(Kind::SharedChecker, concat("the allocator made ", different.size(), " different checkers for ",
                                         checkers_.size(), " workers: some of them share one"));
}

CheckerReport CheckerTest::run()
{
    runSerially();
    if (checkers_.size() > 1)
        runOneByOne();
    runThreads();
    judge();
    return report_;
}

/// Whether so much of the time limit has passed.
bool CheckerTest::isPast(double share) const
{
    return validity::steadySeconds() - start_ > share * options_.timeLimit;
}

/// Numbers of the states; the first round of all threads is in step, so that they ask for the same state at once.
std::vector<std::size_t> CheckerTest::order(unsigned round, unsigned thread) const
{
    std::vector<std::size_t> numbers(tried_);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    if (round > 0)
    {
        std::seed_seq seeds{options_.seed, round, thread};
        std::mt19937 random(seeds);
        std::ranges::shuffle(numbers, random);
    }
    return numbers;
}

void CheckerTest::call(std::size_t state, unsigned worker, CheckerTally& tally)
{
    const StateHandle given(*si_, states_[state].get());
    const StateContents before(*si_->getStateSpace(), given.get());
    const ob::StateValidityChecker& checker = *checkers_[worker < checkers_.size() ? worker : 0];
    watch_.begins(worker, state);
    const double start = validity::steadySeconds();
    try
    {
        const bool valid = checker.isValid(given.get());
        ++(valid ? tally.answers[state].valid : tally.answers[state].invalid);
    }
    catch (const std::exception& error)
    {
        tally.exceptions[error.what()].add(state);
    }
    catch (...)
    {
        tally.exceptions["something that is not a std::exception"].add(state);
    }
    const double seconds = validity::steadySeconds() - start;
    watch_.ends(worker);
    tally.seconds.push_back(seconds);
    if (seconds > tally.slowestSeconds)
    {
        tally.slowestSeconds = seconds;
        tally.slowest = state;
    }
    const auto change = before.changeTo(StateContents(*si_->getStateSpace(), given.get()));
    if (change == StateContents::Change::Values)
        tally.valuesWritten.add(state);
    else if (change == StateContents::Change::BesideValues)
        tally.restWritten.add(state);
}

void CheckerTest::runSerially()
{
    do
        call(tried_++, 0, oneThread_);
    while (tried_ < states_.size() && !isPast(kFirstRound));
    for (const CheckerTally::Answers& answers : oneThread_.answers)
        report_.validStates += answers.valid;
    for (unsigned round = 1; round < options_.rounds; ++round)
        for (const std::size_t state : order(round, 0))
            if (!isPast(kOneThread))
                call(state, 0, oneThread_);
}

/// Every checker gets its share of the states.
void CheckerTest::runOneByOne()
{
    for (std::size_t state = 0; state < tried_ && !isPast(kOneThread); ++state)
        call(state, static_cast<unsigned>(state % checkers_.size()), oneByOne_);
}

void CheckerTest::runRounds(unsigned thread, CheckerTally& tally)
{
    for (unsigned round = 0; round < options_.rounds; ++round)
        for (const std::size_t state : order(round, thread))
            if (!isPast(kAll))
                call(state, thread, tally);
}

void CheckerTest::runThreads()
{
    std::vector<CheckerTally> tallies(options_.threads, CheckerTally(states_.size()));
    std::vector<std::exception_ptr> failures(options_.threads);
    {
        Threads threads;
        for (unsigned thread = 0; thread < options_.threads; ++thread)
            threads.all.emplace_back(
                [&, thread]
                {
                    threads.mayStart.wait(false);
                    try
                    {
                        runRounds(thread, tallies[thread]);
                    }
                    catch (...)
                    {
                        failures[thread] = std::current_exception();
                    }
                });
    }
    for (const std::exception_ptr& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
    for (const CheckerTally& tally : tallies)
        threads_.merge(tally);
}

void CheckerTest::judge()
{
    report_.states = tried_;
    report_.calls = oneThread_.seconds.size() + oneByOne_.seconds.size() + threads_.seconds.size();
    report_.threads = options_.threads;
    const std::size_t wanted =
        options_.rounds * states_.size() * (1 + options_.threads) + (checkers_.size() > 1 ? states_.size() : 0);
    if (report_.calls < wanted)
        find(Kind::TimeLimit, concat("the time limit of ", options_.timeLimit, " s ended the test after ",
                                     report_.calls, " of ", wanted, " calls"));
    judgeOneThread();
    if (!report_.has(Kind::NotDeterministic))
        judgeThreads();
    judgeExceptions();
    judgeWrites();
    judgeTimes();
}

void CheckerTest::judgeOneThread()
{
    CheckerTally::Event differ;
    CheckerTally::Event differOneByOne;
    for (std::size_t state = 0; state < tried_; ++state)
    {
        const auto& [valid, invalid] = oneThread_.answers[state];
        const auto& other = oneByOne_.answers[state];
        if (valid > 0 && invalid > 0)
            differ.add(state);
        else if ((valid > 0 && other.invalid > 0) || (invalid > 0 && other.valid > 0))
            differOneByOne.add(state);
    }
    if (differ.count > 0)
        find(Kind::NotDeterministic, concat("not deterministic: ", differ.count, " of ", tried_,
                                            " states got both answers from one thread; at ", at(differ.state),
                                            " it said valid ", times(oneThread_.answers[differ.state].valid),
                                            " and invalid ", times(oneThread_.answers[differ.state].invalid)));
    if (differOneByOne.count > 0)
        find(Kind::NotDeterministic,
             concat("not deterministic: the checkers of two workers do not agree on ", differOneByOne.count, " of ",
                    tried_, " states, asked one after the other; at ", at(differOneByOne.state)));
}

/// Whether a state gets both answers even from one thread, if that asks as often as all threads did. The checker may
/// have been harmed by the calls of many threads, or answer differently now and then.
bool CheckerTest::wavers(std::size_t state)
{
    CheckerTally again(states_.size());
    for (unsigned i = 0; i < options_.threads * options_.rounds && !isPast(kAll); ++i)
        call(state, 0, again);
    return again.answers[state].valid > 0 && again.answers[state].invalid > 0;
}

void CheckerTest::judgeThreads()
{
    CheckerTally::Event differ;
    for (std::size_t state = 0; state < tried_; ++state)
    {
        const auto& serial = oneThread_.answers[state];
        const auto& answers = threads_.answers[state];
        if ((serial.valid > 0 && answers.invalid > 0) || (serial.invalid > 0 && answers.valid > 0))
            differ.add(state);
    }
    if (differ.count == 0)
        return;
    const auto& serial = oneThread_.answers[differ.state];
    const auto& answers = threads_.answers[differ.state];
    const std::string first = concat(
        "at ", at(differ.state), " one thread found it ", serial.valid > 0 ? "valid" : "invalid", ", ",
        options_.threads, " threads found it valid ", times(answers.valid), " and invalid ", times(answers.invalid));
    if (wavers(differ.state))
        find(Kind::NotDeterministic, concat("not deterministic: ", first, ", and so does one thread now"));
    else
        find(Kind::NotThreadSafe,
             concat(checkers_.size() > 1 ? "not independent: checkers of different workers disturb each other"
                                         : "not thread-safe",
                    ": ", differ.count, " of ", tried_, " states got other answers from ", options_.threads,
                    " threads than from one; ", first));
}

void CheckerTest::judgeExceptions()
{
    CheckerTally all = oneThread_;
    all.merge(oneByOne_);
    const std::set<std::string> onlyWithThreads = [&]
    {
        std::set<std::string> messages;
        for (const auto& [message, event] : threads_.exceptions)
            if (!all.exceptions.contains(message))
                messages.insert(message);
        return messages;
    }();
    all.merge(threads_);
    for (const auto& [message, event] : all.exceptions)
        find(Kind::Exception, concat("throws ", times(event.count),
                                     onlyWithThreads.contains(message) ? ", with several threads only" : "", ", at ",
                                     at(event.state), ": ", message));
}

void CheckerTest::judgeWrites()
{
    CheckerTally all = oneThread_;
    all.merge(oneByOne_);
    all.merge(threads_);
    if (all.valuesWritten.count > 0)
        find(Kind::WritesState, concat("writes into the state that it is given: ", times(all.valuesWritten.count),
                                       " its values were others after the call, at ", at(all.valuesWritten.state)));
    if (all.restWritten.count > 0)
        find(Kind::WritesBesideValues,
             concat("keeps something in the state that it is given, beside the values, ", times(all.restWritten.count),
                    ", at ", at(all.restWritten.state),
                    "; the planner never gives one state to two threads, so this is no fault"));
}

void CheckerTest::judgeTimes()
{
    std::vector<double> seconds = oneThread_.seconds;
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::ranges::nth_element(seconds, middle);
    report_.medianSeconds = *middle;
    report_.slowestSeconds = oneThread_.slowestSeconds;
    if (report_.slowestSeconds > std::max(kSlowSeconds, kSlowTimes * report_.medianSeconds))
        find(Kind::Slow, concat("one call took ", report_.slowestSeconds, " s, the median is ", report_.medianSeconds,
                                " s, at ", at(oneThread_.slowest), "; solve() may return that much later than told"));
}

void CheckerTest::find(Kind kind, std::string text)
{
    report_.findings.push_back({kind, std::move(text)});
}

std::string CheckerTest::at(std::size_t state) const
{
    return describeState(*si_, states_[state].get());
}
}  // namespace specplan::planner
