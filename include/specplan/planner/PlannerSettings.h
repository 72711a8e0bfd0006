// SPDX-License-Identifier: BSD-3-Clause
// C++17-clean: part of the planner's public face.
#pragma once

#include <string>
#include <vector>

namespace specplan
{
/// The names of all speculation policies.
const std::vector<std::string>& speculationPolicies();

/// The names of all predictors.
const std::vector<std::string>& predictors();

/// The names of all ways to evaluate.
const std::vector<std::string>& evaluations();

/// Every knob of SpeculativeAStar with its default. The names in parentheses are the OMPL parameters.
struct PlannerSettings
{
    /// How many checks may run at once (`num_threads`), 0 to 4096; 0 stands for the processors that this process may
    /// use. 1 is sequential A*: no thread is started.
    unsigned numThreads = 0;

    /// What to check ahead (`speculation_policy`): "none", "direction" or "runahead".
    std::string speculationPolicy = "runahead";

    /// How the runahead policy guesses verdicts (`predictor`): "optimistic", "nearby" or "learning".
    std::string predictor = "learning";

    /// Steps that the direction policy looks ahead (`lookahead`), 1 to 1000.
    unsigned lookahead = 4;

    /// Whether every wait lasts until all running checks are back, as in the paper (`barrier`). For reproduction only.
    bool barrier = false;

    /// When states and motions are checked (`evaluation`): "eager", which is A*: states as soon as an
    /// expansion meets them, the inside of a motion when the motion's end is about to be expanded; or "lazy", once they
    /// lie on a path that may be the best or border on an obstacle that was met, which needs fewer checks and more time
    /// of the search's own. Lazily only for path length and goals that are states.
    std::string evaluation = "eager";

    /// Weight of the heuristic (`weight`), 1 to 1e9: the cost is at most this many times the lattice optimum. 0
    /// chooses: 1 up to four axes, 3 up to seven, 5 above; 10 for a first path that better ones follow; at least 3
    /// where the problem definition has no objective, since then nobody has asked for the best path. Of no effect where
    /// the objective does not add up costs.
    double weight = 0.0;

    /// Whether to go on while there is time (`anytime`): with smaller weights, then on finer lattices. Better paths are
    /// looked for where the problem definition has an objective; any path at all where the first lattice has none.
    bool anytime = true;

    /// Whether the first path ends the search (`stop_at_first_path`): `anytime` then only stands for finer lattices
    /// where the first one has no path.
    bool stopAtFirstPath = false;

    /// Lattice spacing as a fraction of the extent of each axis (`resolution`), 1e-6 to 1; 0 chooses by dimension. A
    /// lattice that was asked for is never refined.
    double resolution = 0.0;

    /// Lattice spacing in the units of the axes (`spacing`: numbers separated by commas, one for all axes but angles
    /// beside others; one for each axis; or one for each axis, rotation (radians) and car (of its places)), greater
    /// than 0. Empty: `resolution` decides.
    std::vector<double> spacing;

    /// How many axes may change in one step (`connectivity`), 1 to the number of axes; 0 chooses: all up to three axes,
    /// two above; parts of a compound space one at a time.
    unsigned connectivity = 0;

    /// Whether a step along several axes may pass an invalid corner (`corner_cutting`). If not, the states at all
    /// corners of the box that the step spans have to be valid; for RealVectorStateSpaces.
    bool cornerCutting = true;

    /// Whether the checks of motions compute their costs where the objective is not path length
    /// (`objective_in_checks`): an objective may look at every state on the way. If not, the search does: for
    /// objectives that cost nothing.
    bool objectiveInChecks = true;

    /// Who runs the checks (`executor`): "threads", or "virtual" for simulated time.
    std::string executor = "threads";

    /// Duration of the check of one state on the virtual clock (`virtual_check_cost`), seconds, 0 to 1e6.
    double virtualCheckCost = 1e-3;

    /// Whether an exception of a check leaves solve() (`rethrow_exceptions`); otherwise solve() returns CRASH.
    bool rethrowExceptions = false;
};
}  // namespace specplan
