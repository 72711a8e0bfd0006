// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace specplan::util
{
/// A table by dense numbers of which perhaps only few are used: pages are made when one of their entries is.
///
/// Not thread-safe: one owner.
template <typename T>
class PagedTable
{
public:
    /// The entry of this number, value-initialised on first touch of its page. Its address never changes.
    [[nodiscard]] T& operator[](std::size_t index)
    {
        const std::size_t page = index >> kPageBits;
        if (page >= pages_.size())
            pages_.resize(page + 1);
        if (!pages_[page])
            pages_[page] = std::make_unique<T[]>(kPageSize);
        return pages_[page][index & (kPageSize - 1)];
    }

    /// The entry, or nullptr if its page was never touched.
    [[nodiscard]] const T* find(std::size_t index) const noexcept
    {
        const std::size_t page = index >> kPageBits;
        return page < pages_.size() && pages_[page] ? &pages_[page][index & (kPageSize - 1)] : nullptr;
    }

private:
    static constexpr unsigned kPageBits = 9;
    static constexpr std::size_t kPageSize = std::size_t{1} << kPageBits;

    std::vector<std::unique_ptr<T[]>> pages_;
};
}  // namespace specplan::util
