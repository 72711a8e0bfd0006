// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/RunCheck.h"

#include <ctime>

#include "specplan/validity/BrokenOff.h"

namespace specplan::validity
{
double steadySeconds() noexcept
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double threadCpuSeconds() noexcept
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Completion runCheck(Checker& checker, CheckId check, unsigned worker) noexcept
{
    const double start = steadySeconds();
    Completion completion = runCheckUnmeasured(checker, check, worker);
    completion.seconds = steadySeconds() - start;
    return completion;
}

Completion runCheckUnmeasured(Checker& checker, CheckId check, unsigned worker) noexcept
{
    Completion completion;
    completion.check = check;
    try
    {
        completion.valid = checker.check(check, worker);
    }
    catch (const BrokenOff&)
    {
        completion.brokenOff = true;
    }
    catch (...)
    {
        completion.error = std::current_exception();
    }
    return completion;
}
}  // namespace specplan::validity
