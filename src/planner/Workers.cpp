// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/Workers.h"

#include <algorithm>
#include <utility>

#include <ompl/util/Exception.h>

#include "specplan/planner/MakeExecutor.h"
#include "specplan/util/Processors.h"

namespace specplan::planner
{
namespace ob = ompl::base;

Workers::Workers(ob::SpaceInformationPtr si) : si_(std::move(si)), processors_(util::availableProcessors())
{
}

std::shared_ptr<validity::BudgetShare> Workers::openShare()
{
    if (!budget)
        share_.reset();
    else if (!share_ || share_->budget() != budget)
        share_ = std::make_shared<validity::BudgetShare>(budget);
    return share_;
}

void Workers::prepare(const PlannerSettings& settings)
{
    Make make{settings.numThreads == 0 ? processors_ : settings.numThreads, settings.executor,
              settings.virtualCheckCost, trace, openShare()};
    if (budget)
        make.threads = std::min(make.threads, budget->threads());
    if (executor_ && make == made_)
        return;
    executor_.reset();
    tracer_.reset();
    checker_ = std::make_unique<OmplChecker>(*si_, make.threads);
    if (trace)
        tracer_ = std::make_unique<TracingChecker>(*checker_, make.threads, trace, make.executor == "virtual");
    executor_ = makeExecutor(settings, make.threads, *checker_, tracer_.get(), make.share);
    checker_->setStopSignal(&executor_->stopSignal());
    made_ = std::move(make);
}

OmplChecker::Sources Workers::makeSources() const
{
    OmplChecker::Sources sources;
    const unsigned workers = executor_->workers();
    if (checkerAllocator)
        for (unsigned worker = 0; worker < workers; ++worker)
            sources.checkers.push_back(checkerAllocator(si_, worker));
    else
        sources.checkers.push_back(si_->getStateValidityChecker());
    if (motionValidatorAllocator)
        for (unsigned worker = 0; worker < workers; ++worker)
            sources.motionValidators.push_back(motionValidatorAllocator(si_, worker));
    else
        sources.motionValidators.push_back(si_->getMotionValidator());
    for (const auto& made : sources.checkers)
        if (!made)
            throw ompl::Exception("the state validity checker allocator returned nothing");
    for (const auto& made : sources.motionValidators)
        if (!made)
            throw ompl::Exception("the motion validator allocator returned nothing");
    return sources;
}
}  // namespace specplan::planner
