// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/MakeExecutor.h"

#include <utility>

#include "specplan/validity/InlineExecutor.h"
#include "specplan/validity/RunningClock.h"
#include "specplan/validity/SimulatedPool.h"
#include "specplan/validity/ThreadPoolExecutor.h"
#include "specplan/validity/VirtualExecutor.h"

namespace specplan::planner
{
using validity::CheckId;

std::unique_ptr<validity::Executor> makeExecutor(const PlannerSettings& settings, unsigned threads,
                                                 OmplChecker& checker, TracingChecker* tracer,
                                                 std::shared_ptr<validity::BudgetShare> share)
{
    validity::Checker& first = tracer != nullptr ? static_cast<validity::Checker&>(*tracer) : checker;
    if (settings.executor == "virtual" && tracer != nullptr)
    {
        validity::SimulatedPool::Timing timing;
        timing.ofCheck = [tracer](CheckId, bool) { return tracer->lastSeconds(); };
        const auto clock = std::make_shared<validity::RunningClock>();
        timing.ofSearch = [clock] { return clock->seconds(); };
        timing.afterCheck = tracer->afterCheck();
        return std::make_unique<validity::SimulatedPool>(first, threads, std::move(timing));
    }
    if (settings.executor == "virtual")
        return std::make_unique<validity::VirtualExecutor>(first, threads,
                                                           [&checker, cost = settings.virtualCheckCost](CheckId, bool)
                                                           { return cost * checker.statesOfLastCheck(0); });
    if (threads == 1)
        return std::make_unique<validity::InlineExecutor>(first);
    const bool shares = share != nullptr;
    auto pool = std::make_unique<validity::ThreadPoolExecutor>(first, threads, std::move(share));
    if (!shares)
        pool->startThreads();
    return pool;
}
}  // namespace specplan::planner
