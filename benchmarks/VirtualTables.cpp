// SPDX-License-Identifier: BSD-3-Clause
// The paper's tables and more, on the virtual clock: two runs print the same numbers on every machine. Prints Markdown;
// writes virtual.csv and lazy.csv into the folder given.
#include <array>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <optional>

#include "GridSearch.h"
#include "LazyTables.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/MovingAi.h"
#include "specplan/problems/OutputFile.h"
#include "specplan/problems/SeedMap.h"

namespace specplan::benchmarks
{
namespace
{
struct Case
{
    std::string name;
    problems::GridProblem problem;
    problems::GridCost cost;
    bool cornerCutting;
};

using Suite = std::vector<Case>;

/// Scenes of this size that come with the project, each with its longest query.
Suite bundledSuite(const std::string& scenes, const std::string& size)
{
    Suite suite;
    for (const std::string kind : {"city-", "maze-", "random-", "rooms-"})
    {
        const std::string name = kind + size;
        const std::string file = scenes + "/" + name + ".map";
        const auto entry = problems::readMovingAiScenario(file + ".scen").back();
        suite.push_back(
            {name, {problems::readMovingAiMap(file), entry.start, entry.goal}, problems::GridCost::Length, false});
    }
    return suite;
}

/// The problems of the published figures, where they are at hand.
Suite publishedSuite(const std::string& data)
{
    Suite suite;
    for (const std::string name : {"map3", "map4"})
        suite.push_back({name, problems::readSeedMap(data + "/seed/" + name + ".txt"), problems::GridCost::Seed, true});
    suite.push_back({"hrt201n",
                     {problems::readMovingAiMap(data + "/movingai/hrt201n.map"), {20, 62}, {135, 250}},
                     problems::GridCost::Length,
                     true});
    suite.push_back({"den520d",
                     {problems::readMovingAiMap(data + "/movingai/den520d.map"), {176, 42}, {112, 226}},
                     problems::GridCost::Length,
                     true});
    return suite;
}

/// Runs searches and writes a line of CSV for each.
class Bench
{
public:
    explicit Bench(std::ostream& csv) : csv_(csv)
    {
        csv_ << "problem,policy,predictor,workers,weight,durations,speedup,efficiency,accuracy,coverage,expansions,"
                "checks_used,"
                "demanded_per_expansion,ahead_per_expansion,search_us_per_check\n";
    }

    Outcome run(const Case& problem, const std::string& policy, unsigned workers, double weight, Durations durations,
                const std::string& predictor = "learning")
    {
        const Outcome outcome = searchVirtually(
            {&problem.problem, problem.cost, problem.cornerCutting, policy, predictor, workers, weight, durations});
        const auto& counts = outcome.counts;
        const auto expansions = static_cast<double>(outcome.expansions);
        csv_ << problem.name << ',' << policy << ',' << predictor << ',' << workers << ',' << weight << ','
             << static_cast<int>(durations) << ',' << outcome.speedup << ',' << outcome.speedup / workers << ','
             << counts.accuracy() << ',' << counts.coverage() << ',' << outcome.expansions << ',' << counts.checksUsed
             << ',' << static_cast<double>(counts.demandedChecks) / expansions << ','
             << static_cast<double>(counts.speculativeChecks) / expansions << ','
             << outcome.searchSeconds * 1e6 / static_cast<double>(counts.checksRun) << '\n';
        return outcome;
    }

    /// Speed-ups on all problems of a suite as cells of a table, and their geometric mean.
    void row(const Suite& suite, const std::string& policy, unsigned workers, double weight, Durations durations,
             const std::string& predictor = "learning")
    {
        double logs = 0.0;
        double accuracy = 0.0;
        double coverage = 0.0;
        for (const Case& problem : suite)
        {
            const Outcome outcome = run(problem, policy, workers, weight, durations, predictor);
            logs += std::log(outcome.speedup);
            accuracy += outcome.counts.accuracy() / static_cast<double>(suite.size());
            coverage += outcome.counts.coverage() / static_cast<double>(suite.size());
            std::cout << std::fixed << std::setprecision(2) << outcome.speedup << " | ";
        }
        std::cout << "**" << std::exp(logs / static_cast<double>(suite.size())) << "** | " << std::setprecision(1);
        if (policy == "none")
            std::cout << "- | - |\n";
        else
            std::cout << 100.0 * accuracy << " % | " << 100.0 * coverage << " % |\n";
    }

private:
    std::ostream& csv_;
};

void heading(const Suite& suite, const std::string& title, const std::string& columns)
{
    std::cout << "\n### " << title << "\n\n| " << columns << " | ";
    for (const Case& problem : suite)
        std::cout << problem.name << " | ";
    std::cout << "mean | accuracy | coverage |\n|";
    for (std::size_t i = 0; i < suite.size() + 3 + static_cast<std::size_t>(std::ranges::count(columns, '|')) + 1; ++i)
        std::cout << "---|";
    std::cout << '\n';
}

/// The same problems for the lazy search, whose costs are path lengths.
std::vector<LazyCase> lazySuite(const Suite& suite)
{
    std::vector<LazyCase> cases;
    for (const Case& entry : suite)
        cases.push_back({entry.name, entry.problem, entry.cornerCutting});
    return cases;
}

void printLazySuites(const std::string& folder, const char* data)
{
    problems::writeFile(folder + "/lazy.csv",
                        [data](std::ostream& csv)
                        {
                            csv << "problem,selector,weight,workers,checks_used,checks_run,virtual_time,speedup,"
                                   "accuracy,expansions,search_ns_per_check\n";
                            printLazyTables(lazySuite(bundledSuite(SPECPLAN_SCENES_DIR, "128")), "bundled scenes", csv);
                            if (data != nullptr)
                                printLazyTables(lazySuite(publishedSuite(data)), "published maps", csv);
                        });
}

void printSuite(Bench& bench, const Suite& suite, const std::string& name)
{
    for (const double weight : {1.0, 1000.0, 1e6})
    {
        heading(suite, problems::concat("Speed-up, ", name, ", weight ", weight), "policy | workers");
        for (const std::string policy : {"none", "direction", "runahead"})
            for (const unsigned workers : {2U, 8U, 32U, 128U, 1024U})
            {
                if (policy != "runahead" && workers > 128)
                    continue;  // no longer rises
                std::cout << "| " << policy << " | " << workers << " | ";
                bench.row(suite, policy, workers, weight, Durations::Constant);
            }
    }
    heading(suite, problems::concat("Speed-up by predictor, ", name, ", weight 1"), "predictor | workers");
    for (const std::string predictor : {"optimistic", "nearby", "learning"})
        for (const unsigned workers : {8U, 32U, 128U})
        {
            std::cout << "| " << predictor << " | " << workers << " | ";
            bench.row(suite, "runahead", workers, 1.0, Durations::Constant, predictor);
        }
    heading(suite, problems::concat("Speed-up by durations of checks, ", name, ", weight 1"),
            "durations | policy | workers");
    const std::array<std::pair<const char*, Durations>, 4> kinds{
        {{"constant", Durations::Constant},
         {"uniform 0.5 to 1.5", Durations::Uniform},
         {"log-normal, sigma 1", Durations::LogNormal},
         {"invalid ten times cheaper", Durations::CheapInvalid}}};
    for (const auto& [text, durations] : kinds)
        for (const std::string policy : {"direction", "runahead"})
            for (const unsigned workers : {8U, 32U, 128U})
            {
                std::cout << "| " << text << " | " << policy << " | " << workers << " | ";
                bench.row(suite, policy, workers, 1.0, durations);
            }
}
}  // namespace
}  // namespace specplan::benchmarks

int main(int argc, char** argv)
{
    using namespace specplan;
    const bool lazyOnly = argc == 3 && std::string(argv[1]) == "--lazy";
    if (argc != 2 && !lazyOnly)
    {
        std::cerr << "usage: specplan_bench_virtual [--lazy] FOLDER\n";
        return 2;
    }
    try
    {
        const std::string folder = argv[argc - 1];
        const char* data = std::getenv("SPECPLAN_DATA_DIR");
        if (data != nullptr && *data == '\0')
            data = nullptr;
        if (!lazyOnly)
            problems::writeFile(folder + "/virtual.csv",
                                [data](std::ostream& csv)
                                {
                                    benchmarks::Bench bench(csv);
                                    benchmarks::printSuite(bench, benchmarks::bundledSuite(SPECPLAN_SCENES_DIR, "256"),
                                                           "bundled scenes");
                                    if (data != nullptr)
                                        benchmarks::printSuite(bench, benchmarks::publishedSuite(data),
                                                               "published maps");
                                });
        benchmarks::printLazySuites(folder, data);
    }
    catch (const std::exception& error)
    {
        std::cerr << "specplan_bench_virtual: " << error.what() << '\n';
        return 2;
    }
    return 0;
}
