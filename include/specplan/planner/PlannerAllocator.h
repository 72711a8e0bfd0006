// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: part of the planner's public face.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include <ompl/base/Planner.h>

#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/validity/ThreadBudget.h"

namespace specplan
{
/// Makes a planner for each request, as MoveIt's OMPL interface does: a ConfiguredPlannerAllocator that knows no type
/// of MoveIt's. All planners of one allocator, and of its copies, share one budget of threads, so that several attempts
/// at the same time take no more threads than one.
///
/// Threads: any; each call makes a planner of its own.
class PlannerAllocator
{
public:
    /// Sees each planner after its parameters were set: the place for setStateCompleter and setLatticeAxes.
    using Preparation = std::function<void(SpeculativeAStar& planner)>;

    /// \param budget shared by all planners; a null pointer for none. \param prepare an empty function for none.
    explicit PlannerAllocator(std::shared_ptr<ThreadBudget> budget = std::make_shared<ThreadBudget>(),
                              Preparation prepare = {});

    /// \param specification has a member `config_`, a map from names to values, as
    /// ModelBasedPlanningContextSpecification has. What is no parameter of the planner is passed over.
    template <class Specification>
    ompl::base::PlannerPtr operator()(const ompl::base::SpaceInformationPtr& si, const std::string& name,
                                      const Specification& specification) const
    {
        return allocate(si, name, specification.config_);
    }

    /// The same from the parameters. A value that is refused is logged with its parameter and its range, and the
    /// default stays. \param name of the planner; empty for its own.
    [[nodiscard]] std::shared_ptr<SpeculativeAStar> allocate(const ompl::base::SpaceInformationPtr& si,
                                                             const std::string& name,
                                                             const std::map<std::string, std::string>& config) const;

private:
    std::shared_ptr<ThreadBudget> budget_;
    Preparation prepare_;
};
}  // namespace specplan
