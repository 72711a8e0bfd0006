// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/BuiltWithOmpl.h"

namespace specplan::planner
{
template <typename Built, typename Compiled>
void SameOmpl<Built, Compiled>::check() noexcept
{
}

template struct SameOmpl<BuiltWithOmpl<SPECPLAN_OMPL_MAJOR_VERSION, SPECPLAN_OMPL_MINOR_VERSION>,
                         CompiledWithOmpl<SPECPLAN_OMPL_MAJOR_VERSION, SPECPLAN_OMPL_MINOR_VERSION>>;
}  // namespace specplan::planner
