// SPDX-License-Identifier: BSD-3-Clause
// The planner in random scenes, with faults in the user's code, and made and destroyed by the thousand, for as long as
// told.
#include <random>

#include "FaultRun.h"
#include "ManyPlanners.h"
#include "ProcessCounts.h"
#include "SoakRun.h"

namespace specplan::test
{
namespace
{
constexpr int kScenes = 20;      // a round
constexpr int kFaultyRuns = 40;  // a round
constexpr unsigned kPlanners = 1000;
constexpr std::size_t kWarmUpRounds = 3;
constexpr std::size_t kMayGrow = 32 * 1024;  // kilobytes

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr bool kMeasuresMemory = false;  // sanitizers keep what is freed
#else
constexpr bool kMeasuresMemory = true;
#endif

template <typename List>
auto anyOf(const List& list, std::mt19937_64& random)
{
    return list[random() % list.size()];
}

const std::array<unsigned, 3> kThreads{1, 2, 8};
const std::array<const char*, 2> kEvaluations{"eager", "lazy"};

/// The same expansions, path and cost with all numbers of threads.
void compareThreads(std::mt19937_64& random, SoakRun& run)
{
    const std::uint64_t scene = random() | 1U;
    const std::string evaluation = anyOf(kEvaluations, random);
    SCOPED_TRACE("scene " + std::to_string(scene) + ", " + evaluation);
    const SearchReport sequential = cleanReport(Place::Checker, evaluation, scene);
    for (const unsigned threads : {2U, 4U, 8U})
    {
        FaultyProblem problem(Place::Checker, Fault::None, 0, scene);
        problem.makePlanner(threads, evaluation);
        (void)problem.solve();
        const SearchReport& report = problem.planner->getReport();
        EXPECT_EQ(report.status, sequential.status);
        EXPECT_EQ(report.orderHash, sequential.orderHash);
        EXPECT_EQ(report.checksUsed, sequential.checksUsed);
        EXPECT_TRUE(report.cost == sequential.cost || sequential.status != "solved");
        run.checks += report.checksTotal;
        ++run.problems;
    }
}

void injectFault(std::mt19937_64& random, SoakRun& run)
{
    const Place place = anyOf(kPlaces, random);
    const Fault fault = anyOf(kFaults, random);
    const unsigned threads = anyOf(kThreads, random);
    const std::string evaluation = anyOf(kEvaluations, random);
    const std::uint64_t scene = random() | 1U;
    const std::uint64_t seed = random();
    SCOPED_TRACE(std::string(nameOf(place)) + ' ' + nameOf(fault) + ", " + std::to_string(threads) + " threads, " +
                 evaluation + ", scene " + std::to_string(scene) + ", seed " + std::to_string(seed));
    FaultRun faulty(place, fault, seed, scene);
    faulty.run(threads, evaluation, cleanReport(place, evaluation, scene));
    run.faults += faulty.code().injected();
    run.checks += faulty.code().calls();
    run.problems += 4;
}

/// Compares what the process holds between rounds with what it held after the first ones.
class Watch
{
public:
    void look(SoakRun& run)
    {
        const ProcessCounts now = ProcessCounts::now();
        run.leaks += static_cast<std::uint64_t>(std::abs(FaultyProblem::livingStates()));
        if (++rounds_ <= kWarmUpRounds)
        {
            first_ = {now.threads, now.files, std::max(first_.kilobytes, now.kilobytes)};
            return;
        }
        run.threadsLeft += now.threads - std::min(now.threads, first_.threads);
        run.leaks += now.files - std::min(now.files, first_.files);
        if (kMeasuresMemory && now.kilobytes > first_.kilobytes + kMayGrow)
        {
            std::cerr << "memory has grown from " << first_.kilobytes << " kB to " << now.kilobytes << " kB\n";
            ++run.leaks;
        }
    }

private:
    std::size_t rounds_ = 0;
    ProcessCounts first_;
};

void runRounds(SoakRun& run)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ManyPlanners planners;
    Watch watch;
    while (run.nextRound())
    {
        std::mt19937_64 random(run.seed());
        for (int i = 0; i < kScenes; ++i)
            compareThreads(random, run);
        for (int i = 0; i < kFaultyRuns; ++i)
            injectFault(random, run);
        run.checks += planners.run(kPlanners, 8);
        run.planners += kPlanners;
        watch.look(run);
    }
}
}  // namespace
}  // namespace specplan::test

int main(int argc, char** argv)
{
    specplan::test::SoakRun run(argc, argv);
    if (!run.isUsable())
        return 2;
    specplan::test::runRounds(run);
    return run.finish();
}
