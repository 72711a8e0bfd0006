// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/PlannerAllocator.h"

#include <utility>

namespace specplan
{
PlannerAllocator::PlannerAllocator(std::shared_ptr<ThreadBudget> budget, Preparation prepare)
    : budget_(std::move(budget)), prepare_(std::move(prepare))
{
}

std::shared_ptr<SpeculativeAStar> PlannerAllocator::allocate(const ompl::base::SpaceInformationPtr& si,
                                                             const std::string& name,
                                                             const std::map<std::string, std::string>& config) const
{
    auto planner = std::make_shared<SpeculativeAStar>(si);
    if (!name.empty())
        planner->setName(name);
    planner->setThreadBudget(budget_);
    planner->params().setParams(config, true);  // logs what it refuses
    if (prepare_)
        prepare_(*planner);
    return planner;
}
}  // namespace specplan
