// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "specplan/problems/fcl/Mesh.h"

namespace octomap
{
class OcTree;
}  // namespace octomap

namespace specplan::problems
{
/// Whether OctoMap was there when this was built. Without it all below but isOctoMapFile() throws: readOctoMap() an
/// InputError that says so, the others std::logic_error.
[[nodiscard]] bool hasOctoMap() noexcept;

/// Whether a file's name ends as those of OctoMap's files do, in ".bt" or ".ot".
[[nodiscard]] inline bool isOctoMapFile(const std::string& path)
{
    return path.ends_with(".bt") || path.ends_with(".ot");
}

/// Reads a map of OctoMap, binary (.bt) or with probabilities (.ot), of class octomap::OcTree. The file is looked over
/// before OctoMap sees it, because OctoMap's reader trusts it.
///
/// \throws InputError, one line naming the file: it cannot be read, is no such map or only part of one, or nothing in
/// it is occupied.
[[nodiscard]] std::shared_ptr<const octomap::OcTree> readOctoMap(const std::string& path);

/// Writes a map in OctoMap's binary format (.bt). \throws InputError if the file cannot be written.
void writeOctoMap(const std::string& path, const octomap::OcTree& map);

/// OctoMap's metric bounds: smallest box along the axes around all voxels that are known, free or occupied.
[[nodiscard]] Eigen::AlignedBox3d boundsOf(const octomap::OcTree& map);

/// The occupied voxels, as large as the map has joined them.
[[nodiscard]] std::vector<Eigen::AlignedBox3d> occupiedBoxes(const octomap::OcTree& map);

/// Where occupied voxels meet free or unknown space, as few rectangles of two triangles each that face outward.
[[nodiscard]] Mesh surfaceOf(const octomap::OcTree& map);
}  // namespace specplan::problems
