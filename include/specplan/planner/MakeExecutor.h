// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "specplan/planner/OmplChecker.h"
#include "specplan/planner/PlannerSettings.h"
#include "specplan/planner/TracingChecker.h"
#include "specplan/validity/BudgetShare.h"
#include "specplan/validity/Executor.h"

namespace specplan::planner
{
/// Who runs the checks, by the settings: this thread alone, several threads, or a virtual clock.
/// \param checker and \param tracer must outlive the executor. With a tracer, which may be nullptr, checks go through
/// that, and the virtual clock goes by their recorded durations. \param share of a budget of threads; empty for none.
[[nodiscard]] std::unique_ptr<validity::Executor> makeExecutor(const PlannerSettings& settings, unsigned threads,
                                                               OmplChecker& checker, TracingChecker* tracer,
                                                               std::shared_ptr<validity::BudgetShare> share);
}  // namespace specplan::planner
