// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/StopSignal.h"

#include <ctime>
#include <utility>

#include "specplan/validity/RunCheck.h"

namespace specplan::validity
{
/// A clock that goes by some milliseconds at a time, where that is faster to read.
std::int64_t StopSignal::tick() noexcept
{
    timespec time{};
#if defined(CLOCK_MONOTONIC_COARSE)
    clock_gettime(CLOCK_MONOTONIC_COARSE, &time);
#else
    clock_gettime(CLOCK_MONOTONIC, &time);
    time.tv_nsec -= time.tv_nsec % 1000000;
#endif
    return static_cast<std::int64_t>(time.tv_sec) * 1000000000 + time.tv_nsec;
}

void StopSignal::watch(std::function<bool()> condition)
{
    condition_ = std::move(condition);
    searchThread_ = std::this_thread::get_id();
    trustedFrom_ = lastAsked_ = steadySeconds();
    watched_ = static_cast<bool>(condition_);
    release();
}

void StopSignal::release()
{
    error_ = nullptr;
    set_ = false;
    wakeWaiting();
}

bool StopSignal::ask()
{
    if (!condition_)
        return false;
    if (set_)
    {
        if (error_)
            std::rethrow_exception(std::exchange(error_, nullptr));
        return true;
    }
    // Where everything runs in this thread there is nobody to read the clock for.
    const double now = shared_ ? steadySeconds() : 0.0;
    try
    {
        if (condition_())
            set();
    }
    catch (...)
    {
        set();
        throw;
    }
    if (shared_)
    {
        trustedFrom_ = lastAsked_ = now;
        wakeWaiting();
    }
    return set_;
}

bool StopSignal::askNowAndThen() noexcept
{
    if (!condition_)
        return false;
    if (!set_)
        if (const double now = steadySeconds(); now - lastAsked_ >= kInterval)
        {
            lastAsked_ = now;
            askQuietly();
        }
    return set_;
}

void StopSignal::share(bool shared) noexcept
{
    if (std::exchange(shared_, shared) || !shared_ || !condition_)
        return;
    trustedFrom_ = lastAsked_ = steadySeconds();
    wakeWaiting();
}

void StopSignal::askQuietly() noexcept
{
    if (set_)
        return;
    try
    {
        (void)ask();
    }
    catch (...)
    {
        error_ = std::current_exception();
    }
}

bool StopSignal::lookClosely() noexcept
{
    if (searchThread_.load() == std::this_thread::get_id())
    {
        askQuietly();
        return set_;
    }
    if (isTrusted())
        return set_;
    std::unique_lock lock(mutex_);
    ++waiting_;
    changed_.wait(lock, [this] { return set_ || ended_ || isTrusted(); });
    --waiting_;
    return set_ || ended_;
}

bool StopSignal::isTrusted() const noexcept
{
    return !watched_ || steadySeconds() - trustedFrom_ < kTrust;
}

bool StopSignal::allows() const noexcept
{
    return !set_ && isTrusted();
}

void StopSignal::waitToBegin()
{
    std::unique_lock lock(mutex_);
    ++waiting_;
    changed_.wait(lock, [this] { return ended_ || allows(); });
    --waiting_;
}

void StopSignal::set()
{
    set_ = true;
    wakeWaiting();
}

void StopSignal::end()
{
    ended_ = true;
    set();
}

/// Who counts as waiting looks once more before it sleeps, and who changes something looks at the count afterwards: one
/// of the two sees the other.
void StopSignal::wakeWaiting()
{
    if (waiting_ == 0)
        return;
    {
        const std::lock_guard lock(mutex_);
    }
    changed_.notify_all();
}
}  // namespace specplan::validity
