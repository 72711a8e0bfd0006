// SPDX-License-Identifier: BSD-3-Clause
#include "Plan.h"

#include <ostream>

#include "PlannerList.h"
#include "Problem.h"
#include "Results.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
int plan(const PlanOptions& options, std::ostream& out)
{
    const std::unique_ptr<Problem> problem = readProblem(options.problem.files.front(), options.problem);
    if (options.explain)
    {
        explain(*problem, options, out);
        return 0;
    }
    for (const std::string& file : {options.svgFile, options.traceFile, options.pathFile})
        if (!file.empty())
            problems::requireWritable(file);

    const bool keepOrder = !options.svgFile.empty() || !options.traceFile.empty();
    const Run run = options.planWith.empty() ? planOnce(*problem, options, options.planner, keepOrder)
                                             : planOnceWith(*problem, options, parsePlanner(options.planWith));
    if (!options.svgFile.empty())
        problems::writeFile(options.svgFile, [&](std::ostream& file) { problem->draw(file, run); });
    if (!options.traceFile.empty())
        problems::writeFile(options.traceFile,
                            [&](std::ostream& file)
                            {
                                nlohmann::ordered_json trace = toJson(run);
                                problem->describe(trace, run);
                                file << trace.dump() << '\n';
                            });
    if (!options.pathFile.empty() && run.solved())
        problems::writeFile(options.pathFile,
                            [&](std::ostream& file) { run.setup->getSolutionPath().printAsMatrix(file); });
    if (options.json)
        out << toJson(run).dump(2) << '\n';
    else
        printRun(out, run);
    return run.solved() ? 0 : 1;
}
}  // namespace specplan::command
