// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace specplan::util
{
/// An array that only grows, for large ones: growing hardly holds its owner up. Unlike a vector it leaves it to the
/// system to move what is there, which for large blocks moves no byte, and writes no elements before they are asked
/// for.
///
/// Not thread-safe: one owner.
template <typename T>
class GrowingArray
{
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
    static_assert(alignof(T) <= alignof(std::max_align_t));

public:
    GrowingArray() = default;
    GrowingArray(const GrowingArray&) = delete;
    GrowingArray& operator=(const GrowingArray&) = delete;

    [[nodiscard]] std::size_t size() const noexcept
    {
        return size_;
    }

    /// Adds value-initialised elements until there are at least `size`. \throws std::bad_alloc
    void growTo(std::size_t size)
    {
        if (size <= size_)
            return;
        if (size > capacity_)
            reserve(std::max(size, 2 * capacity_));
        std::uninitialized_value_construct_n(elements_.get() + size_, size - size_);
        size_ = size;
    }

    [[nodiscard]] T& operator[](std::size_t index) noexcept
    {
        return elements_.get()[index];
    }

    [[nodiscard]] const T& operator[](std::size_t index) const noexcept
    {
        return elements_.get()[index];
    }

    [[nodiscard]] T* begin() noexcept
    {
        return elements_.get();
    }

    [[nodiscard]] T* end() noexcept
    {
        return elements_.get() + size_;
    }

private:
    struct Free
    {
        void operator()(T* elements) const noexcept
        {
            std::free(elements);
        }
    };

    void reserve(std::size_t capacity)
    {
        void* const larger = std::realloc(static_cast<void*>(elements_.get()), capacity * sizeof(T));
        if (larger == nullptr)
            throw std::bad_alloc();
        (void)elements_.release();
        elements_.reset(static_cast<T*>(larger));
        capacity_ = capacity;
    }

    std::unique_ptr<T, Free> elements_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};
}  // namespace specplan::util
