// SPDX-License-Identifier: BSD-3-Clause
// From OMPL 1.6 on there is a status INFEASIBLE.
#pragma once

#include <ompl/config.h>

#if SPECPLAN_OTHER_OMPL >= 1006000
#define TYPE_COUNT INFEASIBLE, TYPE_COUNT
#endif
#include_next <ompl/base/PlannerStatus.h>
#undef TYPE_COUNT
