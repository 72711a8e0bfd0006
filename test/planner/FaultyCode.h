// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory_resource>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "specplan/util/Hash.h"

namespace specplan::test
{
/// What can be wrong with a user's code.
enum class Fault
{
    None,
    Throws,
    ThrowsOther,  ///< something that is not a std::exception
    RunsOutOfMemory,
    Sleeps,  ///< a whole second, once
    Lies,    ///< answers differently each time
    Locks,   ///< one thread at a time, and slowly
    Writes,  ///< into the state that it is given
    CallsBack
};

inline constexpr std::array kFaults{Fault::None,     Fault::Throws, Fault::ThrowsOther, Fault::RunsOutOfMemory,
                                    Fault::Sleeps,   Fault::Lies,   Fault::Locks,       Fault::Writes,
                                    Fault::CallsBack};

inline const char* nameOf(Fault fault)
{
    constexpr std::array kNames{"None", "Throws", "ThrowsOther", "RunsOutOfMemory", "Sleeps",
                                "Lies", "Locks",  "Writes",      "CallsBack"};
    return kNames[static_cast<std::size_t>(fault)];
}

/// Whether a search with such code has to end as one without it.
inline bool isHarmless(Fault fault)
{
    return fault == Fault::None || fault == Fault::Sleeps || fault == Fault::Locks || fault == Fault::Writes ||
           fault == Fault::CallsBack;
}

/// Code that fails now and then: as often, but not at the same calls, whatever the threads do. Every user's class of a
/// test asks one of these in every call.
///
/// Threads: any number.
class FaultyCode
{
public:
    static constexpr const char* kMessage = "the user's code failed";

    FaultyCode(Fault fault, std::uint64_t seed) : fault_(fault), seed_(seed)
    {
    }

    /// Only this call fails, counted from 1.
    void failOnly(std::uint64_t call)
    {
        only_ = call;
    }

    /// From now on nothing fails.
    void mend()
    {
        fault_ = Fault::None;
    }

    [[nodiscard]] std::uint64_t calls() const noexcept
    {
        return calls_;
    }

    [[nodiscard]] std::uint64_t injected() const noexcept
    {
        return injected_;
    }

    /// One call. \param state what it is about; may be nullptr. \return whether an answer is to be turned round.
    bool act(const ompl::base::SpaceInformation& si, const ompl::base::State* state)
    {
        const std::uint64_t call = ++calls_;
        const bool rarely = only_ == 0 ? util::mix(seed_, call) % 40 == 0 : call == only_;
        switch (fault_.load())
        {
            case Fault::None:
                return false;
            case Fault::Throws:
            case Fault::ThrowsOther:
            case Fault::RunsOutOfMemory:
                if (rarely)
                    fail();
                return false;
            case Fault::Sleeps:
                if (call == 20)
                    sleep(std::chrono::seconds(1));
                return false;
            case Fault::Lies:
                // Start and goal are checked first; a lie there is no fault of the search.
                if (rarely && call > 10)
                    ++injected_;
                return rarely && call > 10;
            case Fault::Locks:
            {
                const std::lock_guard lock(mutex_);
                sleep(std::chrono::microseconds(20));
                return false;
            }
            case Fault::Writes:
                return write(si, state);
            case Fault::CallsBack:
                return callBack(si, state);
        }
        return false;
    }

private:
    [[noreturn]] void fail()
    {
        ++injected_;
        if (fault_ == Fault::Throws)
            throw std::runtime_error(kMessage);
        if (fault_ == Fault::ThrowsOther)
            throw 42;
        std::array<std::byte, 1024> memory;
        std::pmr::monotonic_buffer_resource arena(memory.data(), memory.size(), std::pmr::null_memory_resource());
        for (std::pmr::vector<std::pmr::string> texts(&arena);;)
            texts.emplace_back(kMessage);
    }

    template <typename Duration>
    void sleep(Duration duration)
    {
        ++injected_;
        std::this_thread::sleep_for(duration);
    }

    bool write(const ompl::base::SpaceInformation& si, const ompl::base::State* state)
    {
        if (state == nullptr)
            return false;
        ++injected_;
        std::vector<double> reals;
        si.getStateSpace()->copyToReals(reals, state);
        for (double& value : reals)
            value = 1.0 - value;
        si.getStateSpace()->copyFromReals(const_cast<ompl::base::State*>(state), reals);
        return false;
    }

    /// Does what checkers do with their space information, and asks it about another state.
    bool callBack(const ompl::base::SpaceInformation& si, const ompl::base::State* state)
    {
        thread_local bool isInside = false;
        if (isInside || state == nullptr)
            return false;
        ++injected_;
        isInside = true;
        ompl::base::State* other = si.cloneState(state);
        ompl::base::State* sample = si.allocState();
        si.allocStateSampler()->sampleUniform(sample);
        si.getStateSpace()->interpolate(state, sample, 0.5, other);
        (void)(si.satisfiesBounds(other) && si.isValid(other) && si.distance(state, other) > 0.0);
        si.freeState(sample);
        si.freeState(other);
        isInside = false;
        return false;
    }

    std::atomic<Fault> fault_;
    std::uint64_t seed_;
    std::uint64_t only_ = 0;
    std::atomic<std::uint64_t> calls_{0};
    std::atomic<std::uint64_t> injected_{0};
    std::mutex mutex_;
};
}  // namespace specplan::test
