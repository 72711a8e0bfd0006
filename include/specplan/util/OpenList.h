// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace specplan::util
{
/// Place of an entry on OPEN. Entries are totally ordered: smaller `f` first, then larger `g`, then older entry.
struct OpenKey
{
    double f;
    double g;
    std::uint64_t age;  ///< number of the push that made the entry; unique

    [[nodiscard]] bool before(const OpenKey& other) const noexcept
    {
        if (f != other.f)
            return f < other.f;
        if (g != other.g)
            return g > other.g;
        return age < other.age;
    }
};

/// OPEN: a 4-ary heap that knows where each item sits, so that an item can be moved up or taken out.
///
/// Items are dense indices. At most one entry an item. Not thread-safe: the search thread owns it.
class OpenList
{
public:
    struct Entry
    {
        OpenKey key;
        std::uint32_t item;
    };

    [[nodiscard]] bool empty() const noexcept
    {
        return heap_.empty();
    }

    [[nodiscard]] std::size_t size() const noexcept
    {
        return heap_.size();
    }

    [[nodiscard]] const Entry& top() const noexcept
    {
        assert(!heap_.empty());
        return heap_.front();
    }

    [[nodiscard]] bool contains(std::uint32_t item) const noexcept
    {
        return item < position_.size() && position_[item] != kAbsent;
    }

    /// All entries, in heap order.
    [[nodiscard]] std::span<const Entry> entries() const noexcept
    {
        return heap_;
    }

    /// Calls `visit` with the first `count` entries in order, or all if there are fewer.
    template <typename Visit>
    void visitFirst(std::size_t count, const Visit& visit)
    {
        const auto after = [this](std::size_t a, std::size_t b) { return heap_[b].key.before(heap_[a].key); };
        rim_.clear();
        if (!heap_.empty())
            rim_.push_back(0);
        for (; count > 0 && !rim_.empty(); --count)
        {
            std::ranges::pop_heap(rim_, after);
            const std::size_t place = rim_.back();
            rim_.pop_back();
            visit(heap_[place]);
            for (std::size_t child = place * kArity + 1; child <= (place + 1) * kArity && child < heap_.size(); ++child)
            {
                rim_.push_back(child);
                std::ranges::push_heap(rim_, after);
            }
        }
    }

    /// Adds the item, or moves its entry to the new place.
    void push(std::uint32_t item, const OpenKey& key)
    {
        if (item >= position_.size())
            position_.resize(std::max<std::size_t>(item + std::size_t{1}, position_.size() * 2), kAbsent);
        if (position_[item] == kAbsent)
        {
            heap_.push_back({key, item});
            siftUp(heap_.size() - 1, {key, item});
            return;
        }
        replace(position_[item], {key, item});
    }

    /// Takes the first entry off.
    Entry pop()
    {
        const Entry first = heap_.front();
        removeAt(0);
        return first;
    }

    /// Takes an item off; it must be there.
    void erase(std::uint32_t item)
    {
        assert(contains(item));
        removeAt(position_[item]);
    }

    void clear() noexcept
    {
        heap_.clear();
        position_.clear();
    }

private:
    static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();
    static constexpr std::size_t kArity = 4;

    void removeAt(std::size_t hole)
    {
        position_[heap_[hole].item] = kAbsent;
        const Entry last = heap_.back();
        heap_.pop_back();
        if (hole < heap_.size())
            replace(hole, last);
    }

    void replace(std::size_t hole, const Entry& entry)
    {
        if (hole > 0 && entry.key.before(heap_[(hole - 1) / kArity].key))
            siftUp(hole, entry);
        else
            siftDown(hole, entry);
    }

    void place(std::size_t hole, const Entry& entry)
    {
        heap_[hole] = entry;
        position_[entry.item] = static_cast<std::uint32_t>(hole);
    }

    void siftUp(std::size_t hole, const Entry& entry)
    {
        while (hole > 0)
        {
            const std::size_t parent = (hole - 1) / kArity;
            if (!entry.key.before(heap_[parent].key))
                break;
            place(hole, heap_[parent]);
            hole = parent;
        }
        place(hole, entry);
    }

    void siftDown(std::size_t hole, const Entry& entry)
    {
        for (;;)
        {
            const std::size_t first = hole * kArity + 1;
            if (first >= heap_.size())
                break;
            std::size_t best = first;
            const std::size_t end = std::min(first + kArity, heap_.size());
            for (std::size_t child = first + 1; child < end; ++child)
                if (heap_[child].key.before(heap_[best].key))
                    best = child;
            if (!heap_[best].key.before(entry.key))
                break;
            place(hole, heap_[best]);
            hole = best;
        }
        place(hole, entry);
    }

    std::vector<Entry> heap_;
    std::vector<std::uint32_t> position_;  ///< item -> index in heap_, or kAbsent
    std::vector<std::size_t> rim_;         ///< scratch of visitFirst(): places that may come next
};
}  // namespace specplan::util
