// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/Broker.h"

#include <utility>

#include "specplan/validity/RunCheck.h"

namespace specplan::validity
{
namespace
{
/// How long a wait may last before the interrupt is asked again.
constexpr std::chrono::milliseconds kPatience{50};
}  // namespace

bool Broker::demand(std::span<const CheckId> checks)
{
    missing_.clear();
    for (const CheckId check : checks)
    {
        Entry& entry = table_[check];
        if (!isKnown(entry.verdict))
            missing_.push_back(check);
        else if (!entry.used)
        {
            ++statistics_.usedReady;
            statistics_.speculativeReady += entry.speculative ? 1 : 0;
            noteUse(entry);
        }
    }
    return missing_.empty() || demandMissing(checks);
}

bool Broker::demandMissing(std::span<const CheckId> checks)
{
    if (!(executor_.runsInline() ? runInline() : waitForMissing()))
        return false;
    if (!errors_.empty())
        for (const CheckId check : checks)
            if (table_[check].failed)
                rethrow(check);
    return true;
}

bool Broker::runInline()
{
    double unasked = 0.0;  // seconds of checks since the interrupt was asked
    for (const CheckId check : missing_)
    {
        Entry& entry = table_[check];
        if (isKnown(entry.verdict))
            continue;  // given twice in one call
        if (unasked > std::chrono::duration<double>(kPatience).count() && interrupt_)
        {
            if (interrupt_())
                return false;
            unasked = 0.0;
        }
        if (!entry.failed)
        {
            executor_.submit(check, Urgency::Demanded);
            ++statistics_.demandedChecks;
            collect(std::chrono::milliseconds{0});
        }
        if (entry.failed)
            return true;  // what comes after is not needed: the caller rethrows
        ++statistics_.usedInline;
        unasked += static_cast<double>(entry.seconds);
        statistics_.waitSeconds += static_cast<double>(entry.seconds);
        noteUse(entry);
    }
    return true;
}

bool Broker::waitForMissing()
{
    const double start = executor_.now();
    collect(std::chrono::milliseconds{0});
    submitMissing();
    askSource();
    double lastAsked = steadySeconds();
    bool interrupted = false;
    while (awaited_ > 0 || (barrier_ && executor_.busy()))
    {
        collect(kPatience);
        if (awaited_ > 0 && source_ != nullptr && source_->keepsAsking())
            askSource();
        if (interrupt_ && steadySeconds() - lastAsked > std::chrono::duration<double>(kPatience).count())
        {
            interrupted = interrupt_();
            lastAsked = steadySeconds();
            if (interrupted)
                break;
        }
    }
    for (const CheckId check : missing_)
        table_[check].awaited = false;
    awaited_ = 0;
    statistics_.waitSeconds += executor_.now() - start;
    return !interrupted;
}

void Broker::submitMissing()
{
    for (const CheckId check : missing_)
    {
        Entry& entry = table_[check];
        if (entry.awaited || entry.failed)
            continue;
        if (isKnown(entry.verdict))  // came back just now
        {
            if (!entry.used)
            {
                ++statistics_.usedReady;
                statistics_.speculativeReady += entry.speculative ? 1 : 0;
                noteUse(entry);
            }
            continue;
        }
        if (entry.verdict == Verdict::InFlight)
            executor_.promote(check);
        else
        {
            executor_.submit(check, Urgency::Demanded);
            entry.verdict = Verdict::InFlight;
            ++statistics_.demandedChecks;
        }
        entry.awaited = true;
        ++awaited_;
    }
}

void Broker::askSource()
{
    const unsigned free = executor_.freeWorkers();
    if (source_ == nullptr || free == 0 || awaited_ == 0)
        return;
    proposals_.clear();
    source_->propose(free, proposals_);
    for (const CheckId check : proposals_)
        prefetch(check);
}

bool Broker::prefetch(CheckId check)
{
    Entry& entry = table_[check];
    if (entry.verdict != Verdict::Unknown || entry.failed || executor_.runsInline())
        return false;
    executor_.submit(check, Urgency::Speculative);
    entry.verdict = Verdict::InFlight;
    entry.speculative = true;
    ++statistics_.speculativeChecks;
    return true;
}

void Broker::collect(std::chrono::milliseconds patience)
{
    completions_.clear();
    executor_.collect(completions_, patience);
    for (Completion& completion : completions_)
        record(completion);
}

void Broker::record(Completion& completion)
{
    const CheckId check = completion.check;
    Entry& entry = table_[check];
    ++statistics_.checksRun;
    statistics_.runSeconds += completion.seconds;
    entry.seconds = static_cast<float>(completion.seconds);
    if (completion.error)
    {
        entry.verdict = Verdict::Unknown;
        entry.failed = true;
        errors_[check] = std::move(completion.error);
        ++statistics_.failuresForgotten;
    }
    else
    {
        entry.verdict = completion.valid ? Verdict::Valid : Verdict::Invalid;
        if (source_ != nullptr)
            source_->learned(check, completion.valid);
    }
    if (!entry.awaited)
        return;
    entry.awaited = false;
    --awaited_;
    if (!entry.failed && !entry.used)
    {
        ++statistics_.usedAfterWait;
        noteUse(entry);
    }
}

void Broker::noteUse(Entry& entry)
{
    entry.used = true;
    ++statistics_.checksUsed;
    statistics_.speculativeUsed += entry.speculative ? 1 : 0;
    statistics_.usedSeconds += static_cast<double>(entry.seconds);
}

void Broker::rethrow(CheckId check)
{
    const std::exception_ptr error = errors_.at(check);
    --statistics_.failuresForgotten;
    std::rethrow_exception(error);
}

void Broker::setVerdict(CheckId check, bool valid)
{
    Entry& entry = table_[check];
    if (entry.verdict == Verdict::Unknown && !entry.failed)
        entry.verdict = valid ? Verdict::Valid : Verdict::Invalid;
}

void Broker::settle()
{
    dropped_.clear();
    executor_.cancelQueued(dropped_);
    for (const CheckId check : dropped_)
    {
        Entry& entry = table_[check];
        statistics_.speculativeDropped += entry.speculative ? 1 : 0;
        entry = Entry{};
    }
    while (executor_.busy())
        collect(kPatience);
    // A failure is remembered no longer than this: whoever asks again wants the check to be tried again.
    for (const auto& [check, error] : errors_)
        table_[check] = Entry{};
    errors_.clear();
}
}  // namespace specplan::validity
