// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace specplan::util
{
/// A growing table of fixed-width rows whose addresses never change.
///
/// Threads: one owner appends and writes. Another thread may read a row that the owner handed to it (through any
/// synchronising hand-over) while the owner goes on appending: growth moves nothing.
template <typename T>
class SegmentedRows
{
    static_assert(std::is_trivially_destructible_v<T>);

public:
    /// \param width number of elements of a row, at least 1.
    explicit SegmentedRows(std::size_t width = 1) : width_(width)
    {
        assert(width > 0);
    }

    [[nodiscard]] std::size_t size() const noexcept
    {
        return size_;
    }

    /// Appends a value-initialised row and returns it.
    T* append()
    {
        const auto [segment, offset] = locate(size_);
        if (!segments_[segment])
            segments_[segment] = allocate((kFirst << segment) * width_);
        // Made row by row: a whole segment at once would hold the owner up, and take memory that may never be used.
        T* const row = segments_[segment].get() + offset * width_;
        std::uninitialized_value_construct_n(row, width_);
        ++size_;
        return row;
    }

    /// Appends rows until there are at least `size`.
    void growTo(std::size_t size)
    {
        while (size_ < size)
            append();
    }

    [[nodiscard]] T* row(std::size_t index) noexcept
    {
        const auto [segment, offset] = locate(index);
        return segments_[segment].get() + offset * width_;
    }

    [[nodiscard]] const T* row(std::size_t index) const noexcept
    {
        const auto [segment, offset] = locate(index);
        return segments_[segment].get() + offset * width_;
    }

    [[nodiscard]] T& operator[](std::size_t index) noexcept
    {
        return *row(index);
    }

    [[nodiscard]] const T& operator[](std::size_t index) const noexcept
    {
        return *row(index);
    }

private:
    struct Place
    {
        std::size_t segment;
        std::size_t offset;
    };

    /// Segment k holds kFirst * 2^k rows and starts at row kFirst * (2^k - 1).
    static Place locate(std::size_t index) noexcept
    {
        const std::size_t shifted = index + kFirst;
        assert(shifted >= kFirst);  // the sum does not wrap
        const auto segment = static_cast<std::size_t>(std::bit_width(shifted)) - kFirstWidth;
        return {segment, shifted - (kFirst << segment)};
    }

    /// Frees what allocate() got.
    struct Free
    {
        std::size_t count = 0;

        void operator()(T* segment) const noexcept
        {
            std::allocator<T>().deallocate(segment, count);
        }
    };
    using Segment = std::unique_ptr<T, Free>;

    [[nodiscard]] static Segment allocate(std::size_t count)
    {
        return Segment(std::allocator<T>().allocate(count), Free{count});
    }

    static constexpr std::size_t kFirst = 1024;
    static constexpr std::size_t kFirstWidth = std::bit_width(kFirst);

    std::size_t width_;
    std::size_t size_ = 0;
    std::array<Segment, 33> segments_;
};
}  // namespace specplan::util
