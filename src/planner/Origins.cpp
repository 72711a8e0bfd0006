// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/Origins.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "specplan/planner/ObjectiveCosts.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
/// Everything about a space that the lattice over it depends on.
void appendSpace(const ob::StateSpace& space, std::vector<double>& out)
{
    out.push_back(space.getLongestValidSegmentLength());
    out.push_back(space.getValidSegmentCountFactor());
    if (const auto* real = dynamic_cast<const ob::RealVectorStateSpace*>(&space))
    {
        const ob::RealVectorBounds& bounds = real->getBounds();
        out.insert(out.end(), bounds.low.begin(), bounds.low.end());
        out.insert(out.end(), bounds.high.begin(), bounds.high.end());
    }
    out.push_back(space.getMaximumExtent());
    if (const auto* compound = dynamic_cast<const ob::CompoundStateSpace*>(&space))
        for (unsigned i = 0; i < compound->getSubspaceCount(); ++i)
        {
            out.push_back(compound->getSubspaceWeight(i));
            appendSpace(*compound->getSubspace(i), out);
        }
}

bool equal(const std::weak_ptr<const void>& a, const std::weak_ptr<const void>& b)
{
    return !a.owner_before(b) && !b.owner_before(a);
}
}  // namespace

Origins::Origins(const ob::SpaceInformation& si, const ob::ProblemDefinition& pdef)
    : checker_(si.getStateValidityChecker()), motionValidator_(si.getMotionValidator())
{
    if (const ob::OptimizationObjectivePtr& objective = pdef.getOptimizationObjective();
        objective && !isPathLength(*objective))
        objective_ = objective;
    appendSpace(*si.getStateSpace(), space_);
}

bool Origins::same(const Origins& other) const
{
    return equal(checker_, other.checker_) && equal(motionValidator_, other.motionValidator_) &&
           equal(objective_, other.objective_) && space_ == other.space_;
}
}  // namespace specplan::planner
