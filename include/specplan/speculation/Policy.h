// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/lattice/NodeTable.h"
#include "specplan/validity/CheckSource.h"

namespace specplan::speculation
{
/// Decides what to check ahead. The search tells it what is being expanded; the broker asks it for checks.
///
/// Threads: search thread only.
class Policy : public validity::CheckSource
{
public:
    /// The search is about to expand `node`, reached from `parent` (kNoNode for a start).
    virtual void expanding(lattice::NodeId node, lattice::NodeId parent) = 0;
};
}  // namespace specplan::speculation
