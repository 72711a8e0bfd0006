// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/CheckTrace.h"

#include "specplan/util/Hash.h"

namespace specplan::planner
{
using lattice::CheckId;
using lattice::Lattice;

std::size_t CheckTrace::Hash::operator()(const Key& key) const noexcept
{
    return util::hashCoordinates(key);
}

CheckTrace::Key CheckTrace::keyOf(const Lattice& lattice, CheckId check)
{
    const auto append = [&lattice](Key& key, lattice::NodeId node)
    {
        const auto coordinates = lattice.coordinates(node);
        key.insert(key.end(), coordinates.begin(), coordinates.end());
    };
    Key key;
    if (!check.isMotion())
    {
        append(key, check.node());
        return key;
    }
    const Lattice::Motion& motion = lattice.motion(check.motion());
    append(key, motion.from);
    append(key, motion.to);
    if (lattice.isGlance(check.motion()))
        key.push_back(0);  // no state and no motion has as many numbers
    return key;
}

const CheckTrace::Entry* CheckTrace::find(const Lattice& lattice, CheckId check) const
{
    const auto found = entries_.find(keyOf(lattice, check));
    return found == entries_.end() ? nullptr : &found->second;
}

void CheckTrace::add(const Lattice& lattice, CheckId check, const Entry& entry)
{
    entries_.emplace(keyOf(lattice, check), entry);
}
}  // namespace specplan::planner
