// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace specplan::validity
{
/// Tells everybody who runs checks that the search is to stop.
///
/// Only the search thread may ask the caller's condition. So that nobody begins a check after the condition has turned
/// true, and the search thread has not noticed since it is busy, the others begin nothing unless the condition has been
/// asked within the last few milliseconds: they wait until it is asked again. The same goes for the states inside a
/// motion. So nothing begins later than `kTrust` after the condition turned true, whatever the search thread does.
///
/// Threads: as each member says; nothing is waited for by the search thread.
class StopSignal
{
public:
    /// How long one answer of the condition is good for, seconds.
    static constexpr double kTrust = 4e-3;

    /// How often the condition is asked during waits and long work, seconds.
    static constexpr double kInterval = 1e-3;

    /// When one thread looked last; kept by whoever calls `isSetInside`.
    struct Look
    {
        std::int64_t tick = 0;
    };

    /// Search thread: takes the signal back, and asks this condition from now on; none if empty.
    void watch(std::function<bool()> condition);

    /// Search thread: takes the signal back. To be called when nothing runs.
    void release();

    /// Search thread: asks the condition, and sets the signal once it returns true. \throws what the condition throws;
    /// the signal is set then, too.
    bool ask();

    /// Search thread: asks it unless it has been asked a moment ago. What it throws is kept for the next `ask`.
    /// \return whether the signal is set.
    bool askNowAndThen() noexcept;

    /// Search thread, which has just asked: whether others have checks in their hands from now on.
    void share(bool shared) noexcept;

    /// Any thread, between two states of one check: whether to break off. Takes a few nanoseconds most of the time; may
    /// wait until the condition has been asked. An exception of the condition is kept for the next `ask`.
    [[nodiscard]] bool isSetInside(Look& look) noexcept
    {
        if (set_)
            return true;
        if (!watched_)
            return false;
        const std::int64_t now = tick();
        if (now == look.tick)
            return false;
        look.tick = now;
        return lookClosely();
    }

    /// Any thread.
    [[nodiscard]] bool isSet() const noexcept
    {
        return set_;
    }

    /// Any thread: whether a check may begin.
    [[nodiscard]] bool allows() const noexcept;

    /// Any thread but the search's: returns when a check may begin, or at the end.
    void waitToBegin();

    /// Search thread: lets all go who wait, for good.
    void end();

private:
    [[nodiscard]] static std::int64_t tick() noexcept;
    [[nodiscard]] bool isTrusted() const noexcept;
    [[nodiscard]] bool lookClosely() noexcept;
    void askQuietly() noexcept;
    void set();
    void wakeWaiting();

    // Search thread only.
    std::function<bool()> condition_;
    std::exception_ptr error_;  ///< what the condition threw inside of a check
    double lastAsked_ = 0.0;
    bool shared_ = false;

    std::atomic<bool> watched_{false};
    std::atomic<bool> set_{false};
    std::atomic<bool> ended_{false};
    std::atomic<double> trustedFrom_{0.0};  ///< when the condition was last asked, while there is somebody to know it
    std::atomic<std::thread::id> searchThread_{};

    std::mutex mutex_;
    std::condition_variable changed_;
    std::atomic<unsigned> waiting_{0};
};
}  // namespace specplan::validity
