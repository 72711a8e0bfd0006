// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

namespace specplan::planner
{
/// The searches of one query, one after the other: with which weight, on which lattice, for how long.
///
/// Where better paths follow the first one, that one is looked for in haste: with a large weight, and on a lattice of
/// twice the usual spacing. Up to four axes that lattice comes first, since it is small: an eighth of the states in
/// three dimensions. With more axes the usual one has a hasty path at once or not soon, so it is tried first. Then
/// weights shrink to 1, and then so does the spacing.
class Schedule
{
public:
    static constexpr std::uint64_t kEndless = std::numeric_limits<std::uint64_t>::max();

    /// What is known when the query is opened.
    struct Terms
    {
        double weight = 1.0;    ///< of the first search, at least 1
        bool automatic = true;  ///< the weight is not the user's
        bool weighted = true;   ///< smaller weights may give better paths
        bool coarsens = false;  ///< the lattice can be searched with twice the usual spacing
        unsigned axes = 1;      ///< degrees of freedom
    };

    /// What happens to the lattice before a search.
    enum class Change
    {
        None,
        Coarsen,  ///< to twice the usual spacing
        Refine    ///< to half the spacing; from the coarse lattice that is the usual one
    };

    /// One search.
    struct Search
    {
        double weight = 1.0;
        Change change = Change::None;
        std::uint64_t patience = kEndless;  ///< verdicts used after which it is given up
    };

    enum class End
    {
        Solved,
        GivenUp,
        Infeasible
    };

    Schedule() = default;
    explicit Schedule(const Terms& terms);

    /// The search that is on.
    [[nodiscard]] const Search& current() const noexcept
    {
        return current_;
    }

    /// Whether that search is on the coarse lattice.
    [[nodiscard]] bool isCoarse() const noexcept
    {
        return coarse_;
    }

    /// Goes on to the search that follows one that ended so.
    const Search& next(End end);

private:
    void afterPath();
    void coarsen(double weight);
    void refine(double weight);

    Terms terms_;
    Search current_;
    bool coarse_ = false;
};
}  // namespace specplan::planner
