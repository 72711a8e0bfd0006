// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "specplan/lattice/NodeTable.h"

namespace specplan::lattice
{
/// One step along up to some axes at a time.
struct Offset
{
    std::vector<Coordinate> values;  ///< -1, 0 or 1 for each axis
    unsigned axes;                   ///< how many of them are not 0, at least 1
};

/// All vectors of {-1, 0, 1}^dimension that change between one and `connectivity` axes, the last axis fastest.
/// \throws std::invalid_argument if there are more than 65536.
[[nodiscard]] std::vector<Offset> gridOffsets(std::size_t dimension, unsigned connectivity);
}  // namespace specplan::lattice
