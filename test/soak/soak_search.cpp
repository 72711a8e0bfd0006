// SPDX-License-Identifier: BSD-3-Clause
// Order equality over random problems for as long as told. Needs no OMPL, so the thread sanitizer sees all of it.
#include "OrderEquality.h"
#include "SoakRun.h"

namespace specplan::test
{
namespace
{
constexpr std::uint64_t kProblems = 50;  // a round

void solve(std::uint64_t seed, std::vector<Configuration>& configurations, SoakRun& run)
{
    const RandomProblem problem(seed, static_cast<CostsBefore>(seed % 3));
    const CellSolution reference = referenceAStar(problem.forReference());
    for (Configuration* configuration : configurationsFor(seed, configurations))
    {
        SCOPED_TRACE("problem " + std::to_string(seed) + ", " + configuration->name);
        run.checks += expectSameSearch(problem, reference, *configuration->checker, *configuration);
        ++run.problems;
    }
}
}  // namespace
}  // namespace specplan::test

int main(int argc, char** argv)
{
    specplan::test::SoakRun run(argc, argv);
    if (!run.isUsable())
        return 2;
    std::vector<specplan::test::Configuration> configurations = specplan::test::allConfigurations();
    while (run.nextRound())
        for (std::uint64_t i = 0; i < specplan::test::kProblems; ++i)
            specplan::test::solve(specplan::util::mix(run.seed(), i) % (std::uint64_t{1} << 40U), configurations, run);
    return run.finish();
}
