// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

namespace specplan::util
{
/// Many rows that grow one by one, each of them in one piece: what is read together lies together.
///
/// A row that is full moves to a place of twice the length; the next row that needs one as long as the old one gets
/// that. Nothing else moves. At most 65535 items a row, 2^32 items in all.
///
/// Not thread-safe: one owner.
template <typename T>
class RowPool
{
public:
    /// Where a row lies. Kept by the owner, one for each row; an empty row takes no place.
    struct Row
    {
        std::uint32_t first = 0;
        std::uint16_t size = 0;
        std::uint8_t width = 0;  ///< the place has 2^(width - 1) items; 0: no place yet
    };

    void append(Row& row, const T& item)
    {
        if (row.size == std::numeric_limits<std::uint16_t>::max())
            throw std::length_error("a row has more than 65535 items");
        if (row.width == 0 || row.size == std::size_t{1} << (row.width - 1))
            move(row);
        at(row.first)[row.size++] = item;
    }

    [[nodiscard]] std::span<const T> items(const Row& row) const noexcept
    {
        return row.width == 0 ? std::span<const T>{} : std::span<const T>{at(row.first), row.size};
    }

private:
    static constexpr std::uint8_t kFirstWidth = 3;
    static constexpr std::uint8_t kMostWidth = 17;
    static constexpr unsigned kChunkBits = kMostWidth - 1;  ///< a chunk holds one of the longest rows

    [[nodiscard]] T* at(std::uint32_t place) const noexcept
    {
        return chunks_[place >> kChunkBits].get() + (place & ((1U << kChunkBits) - 1));
    }

    void move(Row& row)
    {
        const std::uint8_t width = row.width == 0 ? kFirstWidth : static_cast<std::uint8_t>(row.width + 1);
        const std::uint32_t first = take(width);
        if (row.width != 0)
        {
            std::copy_n(at(row.first), row.size, at(first));
            free_[row.width].push_back(row.first);
        }
        row.first = first;
        row.width = width;
    }

    [[nodiscard]] std::uint32_t take(std::uint8_t width)
    {
        std::vector<std::uint32_t>& free = free_[width];
        if (!free.empty())
        {
            const std::uint32_t first = free.back();
            free.pop_back();
            return first;
        }
        const std::size_t length = std::size_t{1} << (width - 1);
        if (const std::size_t room = (chunks_.size() << kChunkBits) - end_; room < length)
        {
            end_ += room;
            if (end_ + (std::size_t{1} << kChunkBits) > std::numeric_limits<std::uint32_t>::max())
                throw std::length_error("a pool of rows has more than 2^32 items");
            chunks_.push_back(std::make_unique_for_overwrite<T[]>(std::size_t{1} << kChunkBits));
        }
        end_ += length;
        return static_cast<std::uint32_t>(end_ - length);
    }

    std::vector<std::unique_ptr<T[]>> chunks_;
    std::size_t end_ = 0;  ///< places from here on were never taken
    std::array<std::vector<std::uint32_t>, kMostWidth + 1> free_;
};
}  // namespace specplan::util
