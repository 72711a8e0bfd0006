// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace specplan::problems
{
/// Where a rigid body is.
struct RigidPose
{
    std::array<double, 3> position{};
    std::array<double, 3> axis{0.0, 0.0, 1.0};  ///< any length but 0
    double angle = 0.0;                         ///< radians about the axis
    std::size_t line = 0;                       ///< of the file, for messages
};

/// Where the body's reference point may be; in the plane the third axis means nothing.
struct RigidVolume
{
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    std::size_t line = 0;
};

/// A file that the problem names, and where it does so.
struct NamedFile
{
    std::string path;  ///< relative to the working directory, or absolute
    std::size_t line = 0;
};

/// A planner that the file asks for.
struct PlannerRequest
{
    std::string name;                               ///< as the file spells it
    std::map<std::string, std::string> parameters;  ///< OMPL's parameters; "name" is what to call it in results
    std::size_t line = 0;
};

/// What a path is judged by.
enum class RigidObjective
{
    Length,
    MaxMinClearance,
    MechanicalWork
};

/// A rigid-body problem as OMPL.app's benchmark files describe it ("3D/cubicles.cfg").
///
/// The robot's reference point is the mean of its mesh's vertices, as in OMPL.app; in the plane its height is kept. The
/// pose of start and goal is that of the reference point.
struct OmplAppProblem
{
    std::string file;
    std::string name;
    NamedFile robot;
    NamedFile world;
    bool planar = false;  ///< x, y, theta instead of a pose in space
    RigidPose start;
    RigidPose goal;
    double goalThreshold = 1e-6;        ///< distance in the state space at which the goal is reached
    std::optional<RigidVolume> volume;  ///< without it, the world's bounding box
    RigidObjective objective = RigidObjective::Length;
    std::optional<double> objectiveThreshold;           ///< a cost that is good enough
    std::optional<double> longestValidSegmentFraction;  ///< of the space's extent, 0 to 1

    std::optional<double> timeLimit;       ///< seconds a run, for benchmarks
    std::optional<double> memoryLimit;     ///< MB a run, for benchmarks
    std::optional<unsigned> runCount;      ///< runs a planner, for benchmarks
    std::vector<PlannerRequest> planners;  ///< in the order of the file

    std::vector<std::string> warnings;  ///< one line each: what the file says and nobody heeds
};

/// Reads such a file. Mesh files and maps are looked for beside it. \throws InputError naming file, line and what was
/// expected; problems with controls are refused.
[[nodiscard]] OmplAppProblem readOmplAppProblem(const std::string& path);

/// The same of a text in memory. \param name what messages call it; mesh files and maps are looked for in its folder.
[[nodiscard]] OmplAppProblem parseOmplAppProblem(std::string text, const std::string& name);
}  // namespace specplan::problems
