// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/Broker.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "specplan/validity/RunCheck.h"

namespace specplan::validity
{
namespace
{
/// How long a wait may last before the interrupt is asked again.
constexpr std::chrono::milliseconds kPatience{2};
/// What it costs to wake a thread that has not done anything yet, about. A check that takes longer is handed out all
/// the same.
constexpr double kWake = 100e-6;
}  // namespace

/// Notes by how much handing checks over takes longer than usual. The first ones start threads: they do not count.
class Broker::HandOverTimer
{
public:
    explicit HandOverTimer(Broker& broker)
        : broker_(broker),
          start_(broker.executor_.now()),
          ranBefore_(broker.statistics_.runSeconds),
          submittedBefore_(broker.submitted_)
    {
    }

    ~HandOverTimer()
    {
        const auto count = static_cast<double>(broker_.submitted_ - submittedBefore_);
        const double ranHere = broker_.statistics_.runSeconds - ranBefore_;
        if (submittedBefore_ >= broker_.executor_.workers() && count > 0.0)
            broker_.accounts_.addHandOver(
                std::max(broker_.executor_.now() - start_ - ranHere - count * SpeculationAccounts::kHandOver, 0.0));
    }

    HandOverTimer(const HandOverTimer&) = delete;
    HandOverTimer& operator=(const HandOverTimer&) = delete;

private:
    Broker& broker_;
    double start_;
    double ranBefore_;
    std::uint64_t submittedBefore_;
};

Broker::Broker(Executor& executor) : executor_(executor), accounts_(executor)
{
}

bool Broker::demand(std::span<const CheckId> checks)
{
    missing_.clear();
    for (const CheckId check : checks)
    {
        Entry& entry = table_[check];
        if (!isKnown(entry.verdict))
            missing_.push_back(check);
        else
            noteReady(entry);
    }
    if (!missing_.empty())
        return demandMissing(checks);
    feed();
    return true;
}

bool Broker::demandMissing(std::span<const CheckId> checks)
{
    if (!runHere() || (!missing_.empty() && !waitForMissing()))
        return false;
    if (!errors_.empty())
        for (const CheckId check : checks)
            if (table_[check].failed)
                rethrow(check);
    return true;
}

/// Whether a check is better run right here. The first one of its kind is, to see what it costs.
bool Broker::shouldRunHere(CheckId check) const
{
    const CostMeter& cost = cost_[check.isMotion() ? 1 : 0];
    const bool early = cost.mean() < kWake && secondsEver_ < warmUp_;
    return executor_.runsInline() ||
           ((cost.isCheap() || cost.knowsNothing() || early || accounts_.workersRest()) && executor_.canRunHere());
}

/// Runs those missing checks in this thread for which that is the better way, and takes them off the list.
bool Broker::runHere()
{
    StopSignal& stop = executor_.stopSignal();
    double unasked = 0.0;  // seconds of checks since the interrupt was asked
    std::size_t left = 0;
    for (std::size_t i = 0; i < missing_.size(); ++i)
    {
        const CheckId check = missing_[i];
        Entry& entry = table_[check];
        if (isKnown(entry.verdict))
            continue;  // given twice in one call
        if (entry.verdict == Verdict::InFlight || (!entry.failed && !shouldRunHere(check)))
        {
            missing_[left++] = check;
            continue;
        }
        if (stop.isSet() || unasked > StopSignal::kInterval)
        {
            if (stop.ask())
                return false;
            unasked = 0.0;
        }
        if (!entry.failed)
            recordHere(check, entry);
        if (stop.isSet() && stop.ask())
            return false;
        if (entry.failed && left == 0)
        {
            missing_.clear();  // what comes after is not needed: the caller rethrows
            return true;
        }
        unasked += static_cast<double>(entry.seconds);
    }
    missing_.resize(left);
    // Others begin only if the interrupt has been asked after what was run here.
    return left == 0 || unasked <= StopSignal::kInterval || !stop.ask();
}

void Broker::recordHere(CheckId check, Entry& entry)
{
    if (!runsAlone_ && source_ != nullptr && allCheap())
    {
        // Telling the source everything would cost more than to check.
        if (std::exchange(sourceListens_, false))
            source_->missed();
        runsAlone_ = true;
    }
    ++statistics_.demandedChecks;
    runOwn(check);
    if (!entry.failed)
        statistics_.waitSeconds += static_cast<double>(entry.seconds);
}

bool Broker::waitForMissing()
{
    /// Nothing is awaited any more when the wait is left, whichever way.
    struct EndOfWait
    {
        Broker& broker;
        double start = broker.executor_.now();
        std::optional<CheckId> own{};  ///< kept from the workers, not run yet

        ~EndOfWait()
        {
            if (own)
                broker.drop({&*own, 1});
            for (const CheckId check : broker.missing_)
                broker.table_[check].awaited = false;
            broker.awaited_ = 0;
            const double end = broker.executor_.now();
            broker.leftAt_ = end;
            broker.statistics_.waitSeconds += end - start;
        }
    };
    EndOfWait wait{*this};
    noteThought();
    sourceListens_ = !accounts_.sourceRests();
    runsAlone_ = false;
    collect(std::chrono::milliseconds{0});
    wait.own = submitMissing();
    if (awaited_ > 0 || wait.own)
        askSource();
    if (stops())
        return false;
    if (wait.own)
        runOwn(*std::exchange(wait.own, std::nullopt));
    while (awaited_ > 0 || (barrier_ && executor_.busy()))
    {
        if (stops())
            return false;
        collect(kPatience);
        // Also when the wait is over: workers go on while the search does.
        if (source_ != nullptr && source_->keepsAsking() && !barrier_)
            askSource();
    }
    return !stops();  // what was broken off is not awaited any more, and has no verdict
}

/// \return a check that this thread is to run itself, rather than wait while others do.
std::optional<CheckId> Broker::submitMissing()
{
    std::optional<CheckId> own;
    for (const CheckId check : missing_)
    {
        Entry& entry = table_[check];
        if (entry.awaited || entry.failed)
            continue;
        if (isKnown(entry.verdict))  // came back just now
        {
            noteReady(entry);
            continue;
        }
        if (entry.verdict == Verdict::InFlight)
            executor_.promote(check);
        else if (!own && executor_.worksHere())
        {
            own = check;
            entry.verdict = Verdict::InFlight;
            ++statistics_.demandedChecks;
            continue;
        }
        else
        {
            const HandOverTimer timer(*this);
            submit(check, Urgency::Demanded);
            entry.verdict = Verdict::InFlight;
            ++statistics_.demandedChecks;
        }
        entry.awaited = true;
        ++awaited_;
    }
    return own;
}

void Broker::runOwn(CheckId check)
{
    runAndTell(check);
    Entry& entry = table_[check];
    if (!isKnown(entry.verdict))
        return;
    ++statistics_.usedInline;
    noteUse(entry);
}

/// The search asks for a verdict that is there.
void Broker::noteReady(Entry& entry)
{
    if (isUsed(entry))
        return;
    if (entry.foundIn != query_)
    {
        ++statistics_.checksReused;
        entry.usedIn = query_;
        return;
    }
    ++statistics_.usedReady;
    statistics_.speculativeReady += entry.speculative ? 1 : 0;
    noteUse(entry);
}

void Broker::feed()
{
    ++chances_;
    if (source_ == nullptr || runsAlone_ || !executor_.runsDry())
        return;
    collect(std::chrono::milliseconds{0});
    if (!source_->keepsAsking())
        return;
    noteThought();
    askSource();
    leftAt_ = executor_.now();
}

/// How long the search thinks between two chances to hand out checks, whether or not it took them.
void Broker::noteThought()
{
    const unsigned chances = std::exchange(chances_, 0) + 1;
    if (leftAt_)
        executor_.searchThought((executor_.now() - *leftAt_) / chances);
}

void Broker::askSource()
{
    if (source_ == nullptr)
        return;
    dropUnwanted();
    unsigned room = source_->keepsAsking() ? executor_.room() : executor_.freeWorkers();
    if (room == 0)
        return;
    settleAccounts();
    if (accounts_.workersRest())
        return;
    proposals_.clear();
    source_->proposeAtHand(room, proposals_);
    room -= handOut();
    if (room == 0 || accounts_.sourceRests())
        return;
    proposals_.clear();
    const double start = executor_.now();
    source_->propose(room, proposals_);
    accounts_.addThought(executor_.now() - start);
    thought_ = true;
    handOut();
    thought_ = false;
}

/// \return how many of the proposals were new.
unsigned Broker::handOut()
{
    const HandOverTimer timer(*this);
    unsigned count = 0;
    for (const CheckId check : proposals_)
        count += prefetch(check) ? 1 : 0;
    return count;
}

/// Gives running ahead a rest where it does not pay.
void Broker::settleAccounts()
{
    if (!accounts_.settle(statistics_.runSeconds))
        return;
    source_->missed();
    sourceListens_ = false;
}

/// Takes back queued checks that have lost their point.
void Broker::dropUnwanted()
{
    if (!std::exchange(sawInvalid_, false))
        return;
    dropped_.clear();
    executor_.cancelUnwanted([this](CheckId check) { return source_->stillWanted(check); }, dropped_);
    drop(dropped_);
}

void Broker::drop(std::span<const CheckId> checks)
{
    for (const CheckId check : checks)
    {
        countGain(check, -1.0);
        Entry& entry = table_[check];
        if (entry.speculative)
            ++statistics_.speculativeDropped;
        else
            --statistics_.demandedChecks;  // of a demand that was interrupted; asking again counts it again
        entry = Entry{};
    }
}

bool Broker::prefetch(CheckId check)
{
    Entry& entry = table_[check];
    if (entry.verdict != Verdict::Unknown || entry.failed || executor_.runsInline() || executor_.stopSignal().isSet())
        return false;
    if (allCheap() && executor_.canRunHere())
        return false;  // the search will run it faster itself
    if (executor_.worksHere() && costOf(check).mean() < SpeculationAccounts::kHandOver && !costOf(check).knowsNothing())
    {
        runAheadHere(check, entry);
        return true;
    }
    submit(check, Urgency::Speculative);
    entry.verdict = Verdict::InFlight;
    entry.speculative = true;
    ++statistics_.speculativeChecks;
    return true;
}

void Broker::submit(CheckId check, Urgency urgency)
{
    executor_.submit(check, urgency);
    ++submitted_;
    Entry& entry = table_[check];
    entry.handedOver = true;
    entry.thoughtOf = thought_;
    countGain(check, 1.0);
}

/// Notes what it saves the search that another thread runs a check; with -1 that it comes to nothing.
void Broker::countGain(CheckId check, double times)
{
    Entry& entry = table_[check];
    if (!entry.handedOver)
        return;
    accounts_.addGain(costOf(check).mean(), entry.thoughtOf, times);
    entry.handedOver = times > 0.0;
}

/// Running a check ahead in this thread takes no longer than handing it out would.
void Broker::runAheadHere(CheckId check, Entry& entry)
{
    ++statistics_.speculativeChecks;
    entry.speculative = true;
    runAndTell(check);
}

void Broker::runAndTell(CheckId check)
{
    Completion completion = executor_.runHere(check);
    record(completion);
    if (sourceListens_ && source_ != nullptr && isKnown(table_[check].verdict))
        source_->learned(check, completion.valid);
}

void Broker::collect(std::chrono::milliseconds patience)
{
    completions_.clear();
    executor_.collect(completions_, patience);
    for (Completion& completion : completions_)
        record(completion);
    tellSource();
}

/// Passes the verdicts just collected on to the source.
void Broker::tellSource()
{
    if (source_ == nullptr || !sourceListens_)
        return;
    try
    {
        for (const Completion& completion : completions_)
            if (isKnown(verdict(completion.check)))
                source_->learned(completion.check, completion.valid);
    }
    catch (...)
    {
        source_->missed();
        throw;
    }
}

void Broker::record(Completion& completion)
{
    const CheckId check = completion.check;
    Entry& entry = table_[check];
    if (completion.brokenOff)
    {
        awaited_ -= entry.awaited ? 1 : 0;
        drop({&check, 1});
        return;
    }
    ++statistics_.checksRun;
    statistics_.runSeconds += completion.seconds;
    secondsEver_ += completion.seconds;
    entry.seconds = static_cast<float>(completion.seconds);
    entry.foundIn = query_;
    if (completion.here)
        countGain(check, -1.0);
    if (completion.measured)
        costOf(check).add(completion.seconds);
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
        sawInvalid_ = sawInvalid_ || !completion.valid;
    }
    if (!entry.awaited)
        return;
    entry.awaited = false;
    --awaited_;
    if (!entry.failed && !isUsed(entry))
    {
        ++statistics_.usedAfterWait;
        noteUse(entry);
    }
}

void Broker::noteUse(Entry& entry)
{
    entry.usedIn = query_;
    ++statistics_.checksUsed;
    statistics_.speculativeUsed += entry.speculative ? 1 : 0;
    statistics_.usedSeconds += static_cast<double>(entry.seconds);
}

void Broker::rethrow(CheckId check)
{
    const std::exception_ptr error = errors_.at(check);
    if (Entry& entry = table_[check]; !entry.reported)
    {
        entry.reported = true;
        --statistics_.failuresForgotten;
    }
    std::rethrow_exception(error);
}

void Broker::setVerdict(CheckId check, bool valid)
{
    Entry& entry = table_[check];
    if (entry.verdict != Verdict::Unknown || entry.failed)
        return;
    entry.verdict = valid ? Verdict::Valid : Verdict::Invalid;
    entry.foundIn = query_;
}

void Broker::beginQuery()
{
    // A number used before would take verdicts of long ago for new ones, which only miscounts.
    query_ =
        query_ == std::numeric_limits<std::uint16_t>::max() ? std::uint16_t{1} : static_cast<std::uint16_t>(query_ + 1);
    statistics_ = {};
}

void Broker::settle()
{
    dropped_.clear();
    executor_.cancelQueued(dropped_);
    drop(dropped_);
    while (executor_.busy())
    {
        try
        {
            executor_.stopSignal().askNowAndThen();  // long motions may be broken off
            collect(kPatience);
        }
        catch (...)
        {
            // The source could not follow, which only costs speed: tellSource() has told it to start over.
        }
    }
    // A failure is remembered no longer than this: whoever asks again wants the check to be tried again.
    for (const auto& [check, error] : errors_)
        table_[check] = Entry{};
    errors_.clear();
    leftAt_.reset();
    executor_.stopSignal().release();
}
}  // namespace specplan::validity
