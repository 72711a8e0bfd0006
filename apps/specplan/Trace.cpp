// SPDX-License-Identifier: BSD-3-Clause
#include "Trace.h"

#include <iomanip>
#include <ostream>

namespace specplan::command
{
namespace ob = ompl::base;

void writeChecks(std::ostream& out, const Run& run)
{
    std::vector<double> reals;
    const auto writeState = [&](const ob::State* state)
    {
        run.setup->getStateSpace()->copyToReals(reals, state);
        const char* separator = "";
        for (const double value : reals)
        {
            out << separator << value;
            separator = " ";
        }
    };
    out << "kind,valid,used,start_s,duration_s,worker,from,to\n" << std::setprecision(9);
    run.planner->visitChecks(
        [&](const SpeculativeAStar::CheckRun& check)
        {
            out << (check.to == nullptr ? "state"
                    : check.glance      ? "glance"
                                        : "motion")
                << ',' << check.valid << ',' << check.used << ',' << check.start << ',' << check.seconds << ','
                << check.worker << ',';
            writeState(check.from);
            out << ',';
            if (check.to != nullptr)
                writeState(check.to);
            out << '\n';
        });
}
}  // namespace specplan::command
