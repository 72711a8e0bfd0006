// SPDX-License-Identifier: BSD-3-Clause
#include "LazyTables.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <stdexcept>

#include "GridSearch.h"

namespace specplan::benchmarks
{
namespace
{
using search::Selector;

constexpr std::array<std::pair<Selector, const char*>, 4> kSelectors{{{Selector::LeastLikely, "least likely"},
                                                                      {Selector::Forward, "forward"},
                                                                      {Selector::Backward, "backward"},
                                                                      {Selector::Alternate, "alternate"}}};

struct Problem
{
    const LazyCase* scene;
    double checks;  ///< of sequential A*
    double cost;
};

class LazyBench
{
public:
    LazyBench(const std::vector<LazyCase>& suite, std::ostream& csv) : csv_(csv)
    {
        for (const LazyCase& scene : suite)
        {
            GridSearch wanted = wantedFor(scene, 1, 1.0);
            wanted.policy = "none";
            const Outcome eager = searchVirtually(wanted);
            problems_.push_back({&scene, static_cast<double>(eager.counts.checksUsed), eager.cost});
        }
    }

    [[nodiscard]] const std::vector<Problem>& problems() const
    {
        return problems_;
    }

    [[nodiscard]] static GridSearch wantedFor(const LazyCase& scene, unsigned workers, double weight)
    {
        GridSearch wanted;
        wanted.problem = &scene.problem;
        wanted.cornerCutting = scene.cornerCutting;
        wanted.workers = workers;
        wanted.weight = weight;
        return wanted;
    }

    Outcome run(const Problem& problem, unsigned workers, Selector selector, const char* selectorName,
                double weight = 1.0)
    {
        const Outcome outcome = searchLazily(wantedFor(*problem.scene, workers, weight), selector);
        if (outcome.cost < problem.cost * (1.0 - 1e-9) || outcome.cost > problem.cost * (weight + 1e-9))
            throw std::runtime_error(problem.scene->name + ": the lazy search's cost is not that of A*");
        const auto& counts = outcome.counts;
        csv_ << problem.scene->name << ',' << selectorName << ',' << weight << ',' << workers << ','
             << counts.checksUsed << ',' << counts.checksRun << ',' << outcome.seconds << ','
             << problem.checks / outcome.seconds << ',' << counts.accuracy() << ',' << outcome.expansions << ','
             << outcome.searchSeconds * 1e9 / static_cast<double>(counts.checksRun) << '\n';
        return outcome;
    }

private:
    std::ostream& csv_;
    std::vector<Problem> problems_;
};

void heading(const LazyBench& bench, const std::string& title, const std::string& columns, bool mean)
{
    std::cout << "\n### " << title << "\n\n| " << columns << " | ";
    for (const Problem& problem : bench.problems())
        std::cout << problem.scene->name << " | ";
    std::cout << (mean ? "mean |\n|" : "\n|");
    const auto bars = static_cast<std::size_t>(std::ranges::count(columns, '|'));
    for (std::size_t i = 0; i < bench.problems().size() + bars + (mean ? 2 : 1); ++i)
        std::cout << "---|";
    std::cout << '\n';
}

void printSpeedUps(LazyBench& bench, const std::string& name)
{
    heading(bench, "Lazy: speed-up over sequential A*, checks run, and search time a check in us, " + name, "workers",
            true);
    for (const unsigned workers : {1U, 8U, 32U, 128U})
    {
        std::cout << "| " << workers << " | ";
        double logs = 0.0;
        for (const Problem& problem : bench.problems())
        {
            const Outcome outcome = bench.run(problem, workers, Selector::LeastLikely, "least likely");
            const double speedup = problem.checks / outcome.seconds;
            logs += std::log(speedup);
            const auto run = static_cast<double>(outcome.counts.checksRun);
            std::cout << std::fixed << std::setprecision(1) << speedup << ", " << outcome.counts.checksRun << ", "
                      << std::setprecision(0) << outcome.searchSeconds * 1e6 / run << " | ";
        }
        std::cout << "**" << std::setprecision(1) << std::exp(logs / static_cast<double>(bench.problems().size()))
                  << "** |" << std::endl;
    }
}

void printChecks(LazyBench& bench, const std::string& name)
{
    heading(bench, "Lazy: checks of one worker, " + name, "search | weight", false);
    std::cout << "| A* | 1 | ";
    for (const Problem& problem : bench.problems())
        std::cout << std::setprecision(0) << problem.checks << " | ";
    std::cout << '\n';
    for (const double weight : {1.0, 1.5, 3.0, 10.0})
    {
        std::cout << "| lazy A* | " << std::setprecision(1) << weight << " | ";
        for (const Problem& problem : bench.problems())
            std::cout << searchBaseline(LazyBench::wantedFor(*problem.scene, 1, weight)).checks << " | ";
        std::cout << '\n';
    }
    for (const double weight : {1.5, 3.0, 10.0})
    {
        std::cout << "| least likely | " << std::setprecision(1) << weight << " | ";
        for (const Problem& problem : bench.problems())
            std::cout << bench.run(problem, 1, Selector::LeastLikely, "least likely", weight).counts.checksRun << " | ";
        std::cout << '\n';
    }
    for (const auto& [selector, text] : kSelectors)
    {
        std::cout << "| " << text << " | 1 | ";
        for (const Problem& problem : bench.problems())
            std::cout << bench.run(problem, 1, selector, text).counts.checksRun << " | ";
        std::cout << '\n';
    }
}
}  // namespace

void printLazyTables(const std::vector<LazyCase>& suite, const std::string& name, std::ostream& csv)
{
    LazyBench bench(suite, csv);
    printSpeedUps(bench, name);
    printChecks(bench, name);
}
}  // namespace specplan::benchmarks
