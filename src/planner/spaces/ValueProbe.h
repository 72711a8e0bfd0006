// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/base/StateSpace.h>

namespace specplan::planner
{
/// Finds out about the values of copyToReals() by moving one at a time, all others as in one state of the space.
class ValueProbe
{
public:
    using Values = std::vector<double>;

    /// What a space does to a state to fill in values that others determine.
    enum class Filling
    {
        None,
        Bounds,        ///< enforceBounds()
        Interpolation  ///< interpolate() from the state to itself
    };

    ValueProbe(const ompl::base::StateSpacePtr& space, const ompl::base::State* origin);

    [[nodiscard]] const Values& origin() const noexcept
    {
        return origin_;
    }

    /// All values after one has been moved and enforceBounds() called.
    [[nodiscard]] Values enforced(std::size_t value, double to)
    {
        return filled(value, to, Filling::Bounds);
    }

    /// The same with another way to fill in values.
    [[nodiscard]] Values filled(std::size_t value, double to, Filling filling);

    /// How the space fills in this value from others, whatever it was before; None if it does not, or nobody can tell.
    [[nodiscard]] Filling fillingOf(std::size_t value);

    /// Another value that enforceBounds() changes when it has to change this one. \param filled values that do not
    /// count.
    [[nodiscard]] std::optional<std::size_t> changesWith(std::size_t value, const std::vector<bool>& filled);

    /// Fills in the values of a state.
    static void fill(const ompl::base::StateSpace& space, ompl::base::State* state, Filling filling);

private:
    [[nodiscard]] bool overwrites(std::size_t value, Filling filling);
    [[nodiscard]] bool followsOthers(std::size_t value, Filling filling);

    const ompl::base::StateSpacePtr space_;
    ompl::base::ScopedState<> state_;
    Values origin_;
};
}  // namespace specplan::planner
