// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/util/OpenList.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace specplan::util
{
namespace
{
struct Before
{
    bool operator()(const OpenKey& a, const OpenKey& b) const
    {
        return a.before(b);
    }
};

TEST(OpenKey, SmallerFThenLargerGThenOlder)
{
    EXPECT_TRUE((OpenKey{1.0, 0.0, 9}.before({2.0, 5.0, 1})));
    EXPECT_TRUE((OpenKey{1.0, 5.0, 9}.before({1.0, 4.0, 1})));
    EXPECT_TRUE((OpenKey{1.0, 5.0, 1}.before({1.0, 5.0, 2})));
    EXPECT_FALSE((OpenKey{1.0, 5.0, 2}.before({1.0, 5.0, 2})));
}

TEST(OpenList, BehavesLikeASortedMap)
{
    std::mt19937_64 random(7);
    OpenList open;
    std::map<OpenKey, std::uint32_t, Before> model;
    std::map<std::uint32_t, OpenKey> keys;
    for (std::uint64_t age = 0; age < 20000; ++age)
    {
        const auto item = static_cast<std::uint32_t>(random() % 300);
        switch (random() % 4)
        {
            case 0:
            case 1:
            {
                const OpenKey key{static_cast<double>(random() % 10), static_cast<double>(random() % 5), age};
                if (const auto old = keys.find(item); old != keys.end())
                    model.erase(old->second);
                open.push(item, key);
                model[key] = item;
                keys[item] = key;
                break;
            }
            case 2:
                if (!model.empty())
                {
                    ASSERT_EQ(open.top().item, model.begin()->second);
                    const OpenList::Entry first = open.pop();
                    ASSERT_EQ(first.item, model.begin()->second);
                    keys.erase(first.item);
                    model.erase(model.begin());
                }
                break;
            default:
                ASSERT_EQ(open.contains(item), keys.contains(item));
                if (keys.contains(item))
                {
                    open.erase(item);
                    model.erase(keys[item]);
                    keys.erase(item);
                }
        }
        ASSERT_EQ(open.size(), model.size());
        ASSERT_EQ(open.empty(), model.empty());
        if (age % 16 != 0)
            continue;
        const std::size_t count = random() % 40;
        auto expected = model.begin();
        std::size_t visited = 0;
        open.visitFirst(count,
                        [&](const OpenList::Entry& entry)
                        {
                            ASSERT_NE(expected, model.end());
                            ASSERT_EQ(entry.item, (expected++)->second);
                            ++visited;
                        });
        ASSERT_EQ(visited, std::min(count, model.size()));
    }
    while (!model.empty())
    {
        ASSERT_EQ(open.pop().item, model.begin()->second);
        model.erase(model.begin());
    }
}

TEST(OpenList, ClearForgetsEverything)
{
    OpenList open;
    open.push(5, {1.0, 1.0, 0});
    open.clear();
    EXPECT_TRUE(open.empty());
    EXPECT_FALSE(open.contains(5));
    open.push(5, {2.0, 1.0, 1});
    EXPECT_EQ(open.top().item, 5U);
}
}  // namespace
}  // namespace specplan::util
