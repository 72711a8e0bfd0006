// SPDX-License-Identifier: BSD-3-Clause
// A program without OMPL that calls into the core library.
#include <array>

#include <specplan/lattice/NodeTable.h>

int main()
{
    specplan::lattice::NodeTable table(2);
    const std::array<specplan::lattice::Coordinate, 2> place{3, 4};
    return table.intern(place.data()) == table.find(place.data()) ? 0 : 1;
}
