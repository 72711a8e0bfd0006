// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace specplan::problems
{
/// A cell of a map: column and row, both from 0, (0, 0) top left.
using GridCell = std::array<int, 2>;

/// A map of free and blocked cells.
class GridMap
{
public:
    /// Larger maps in files are refused.
    static constexpr double kMaxCells = 1 << 28;

    /// All cells blocked. \param width, height at least 1.
    GridMap(int width, int height)
        : width_(width), height_(height), free_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    {
    }

    [[nodiscard]] int width() const noexcept
    {
        return width_;
    }

    [[nodiscard]] int height() const noexcept
    {
        return height_;
    }

    [[nodiscard]] bool contains(int x, int y) const noexcept
    {
        return x >= 0 && x < width_ && y >= 0 && y < height_;
    }

    /// Whether the cell is free; cells outside of the map are not.
    [[nodiscard]] bool isFree(int x, int y) const noexcept
    {
        return contains(x, y) && free_[index(x, y)] != 0;
    }

    /// The cell must be inside the map.
    void setFree(int x, int y, bool free) noexcept
    {
        free_[index(x, y)] = free ? 1 : 0;
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const noexcept
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_;
    int height_;
    std::vector<std::uint8_t> free_;
};

/// A map with one start and one goal.
struct GridProblem
{
    GridMap map;
    GridCell start;
    GridCell goal;
};
}  // namespace specplan::problems
