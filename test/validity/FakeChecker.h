// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <stdexcept>
#include <utility>

#include "specplan/validity/Checker.h"

namespace specplan::test
{
using validity::CheckId;

inline CheckId stateCheck(std::uint32_t node)
{
    return CheckId::ofState(node);
}

/// Even nodes are valid; what else happens is up to the test.
class FakeChecker : public validity::Checker
{
public:
    bool check(CheckId check, unsigned worker) override
    {
        const int now = ++running;
        for (int most = mostAtOnce; now > most && !mostAtOnce.compare_exchange_weak(most, now);)
        {
        }
        ++calls;
        const Leave leave{running};
        if (during)
            during(check, worker);
        return check.isMotion() || check.node() % 2 == 0;
    }

    std::function<void(CheckId check, unsigned worker)> during;
    std::atomic<int> calls{0};
    std::atomic<int> running{0};
    std::atomic<int> mostAtOnce{0};

private:
    struct Leave
    {
        std::atomic<int>& running;
        ~Leave()
        {
            --running;
        }
    };
};
}  // namespace specplan::test
