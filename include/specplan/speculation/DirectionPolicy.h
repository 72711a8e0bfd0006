// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "specplan/lattice/Lattice.h"
#include "specplan/speculation/Policy.h"
#include "specplan/validity/Broker.h"

namespace specplan::speculation
{
/// The rule of "Speculative Path Planning" (Bakhshalipour, Qadri, Guri; Algorithm 2): the search is likely to go on the
/// way it came. From the expanded node it steps along the direction parent -> node, up to `lookahead` times, and
/// proposes the unknown checks around each step, nearest step first.
class DirectionPolicy : public Policy
{
public:
    /// \param lookahead steps along the direction (the paper's max_forward_speculation), at least 1.
    /// \param lattice, broker must outlive the policy.
    DirectionPolicy(lattice::Lattice& lattice, const validity::Broker& broker, unsigned lookahead);

    void expanding(lattice::NodeId node, lattice::NodeId parent) override;
    void propose(std::size_t count, std::vector<lattice::CheckId>& out) override;

    void learned(lattice::CheckId, bool) override
    {
    }

    [[nodiscard]] bool keepsAsking() const noexcept override
    {
        return false;
    }

private:
    void add(lattice::CheckId check, std::size_t full, std::vector<lattice::CheckId>& out) const;
    void proposeMotion(lattice::NodeId from, lattice::NodeId to, std::size_t full, std::vector<lattice::CheckId>& out);
    void proposeAround(lattice::NodeId node, std::size_t full, std::vector<lattice::CheckId>& out);

    lattice::Lattice& lattice_;
    const validity::Broker& broker_;
    unsigned lookahead_;
    lattice::NodeId node_ = lattice::kNoNode;
    lattice::NodeId parent_ = lattice::kNoNode;
    lattice::Successors around_;
};
}  // namespace specplan::speculation
