// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/validity/ThreadPoolExecutor.h"

#if defined(__linux__)
#include <sched.h>
#endif

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include "specplan/util/Processors.h"
#include "specplan/validity/TakeUnwanted.h"

namespace specplan::validity
{
namespace
{
/// A check that is on a processor for this share of its time counts as busy; where threads share processors, busy ones
/// may come close.
constexpr double kBusyShare = 0.2;

/// Shorter checks say nothing of those that take the time.
constexpr double kTellingSeconds = 5e-6;

/// Number of the processor that the calling thread runs on; negative if that cannot be told.
int currentProcessor() noexcept
{
#if defined(__linux__)
    return sched_getcpu();
#else
    return -1;
#endif
}

void pause() noexcept
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("isb" ::: "memory");  // "yield" does nothing on most of these processors
#else
    std::this_thread::yield();
#endif
}

/// Waits for `ready` without sleeping, for so many seconds at most.
template <typename Ready>
void spin(double seconds, const Ready& ready)
{
    constexpr int kLooksPerClock = 64;
    const double end = steadySeconds() + seconds;
    do
        for (int i = 0; i < kLooksPerClock; ++i)
        {
            if (ready())
                return;
            pause();
        }
    while (steadySeconds() < end);
}
}  // namespace

ThreadPoolExecutor::ThreadPoolExecutor(Checker& checker, unsigned workers, std::shared_ptr<BudgetShare> share)
    : checker_(checker),
      workers_(std::max(workers, 1U)),
      processors_(util::availableProcessors()),
      share_(std::move(share)),
      mayUse_(share_ ? 1 + share_->limit() : workers_),
      threadLimit_(threadsToRun()),
      lastIsReserved_(searchThreadShouldWork()),
      numberTaken_(workers_)
{
    threads_.reserve(workers_);
}

ThreadPoolExecutor::~ThreadPoolExecutor()
{
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        demanded_.clear();
        speculative_.clear();
    }
    stop_.end();
    if (share_)
        share_->wake();
    workAvailable_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void ThreadPoolExecutor::startThreads()
{
    for (unsigned inHand = 1; inHand <= std::min(workers_, processors_); ++inHand)
        startThreadFor(inHand);
}

Completion ThreadPoolExecutor::runHere(CheckId check)
{
    // The last number belongs to the search thread, or nobody has one now.
    Completion completion = runner_.run(checker_, check, workers_ - 1);
    completion.here = true;
    learn(completion);
    return completion;
}

bool ThreadPoolExecutor::worksHere() const noexcept
{
    return searchThreadShouldWork() && !lastNumberTaken_ && !ownTaken_;
}

unsigned ThreadPoolExecutor::room() const noexcept
{
    return supply_.room(usedWorkers(), worksHere(), inHand_,
                        {queued_[0].load(std::memory_order_relaxed), queued_[1].load(std::memory_order_relaxed)});
}

bool ThreadPoolExecutor::runsDry()
{
    return queued() == 0 && !threads_.empty() && (inHand_ == 0 || done_.load(std::memory_order_relaxed) > 0);
}

void ThreadPoolExecutor::submit(CheckId check, Urgency urgency)
{
    startThreadFor(inHand_ + 1);
    stop_.share(true);
    searchProcessor_.store(currentProcessor(), std::memory_order_relaxed);
    bool wake = false;
    {
        const std::lock_guard lock(mutex_);
        (urgency == Urgency::Demanded ? demanded_ : speculative_).push_back(check);
        queued_[kindOf(check)].fetch_add(1, std::memory_order_relaxed);
        wake = sleepers_ > 0 && running_ < threadLimit_;
        if (wake)
            --sleepers_;
    }
    ++inHand_;
    if (wake)
        workAvailable_.notify_one();
}

void ThreadPoolExecutor::startThreadFor(std::size_t inHand)
{
    const std::size_t wanted = std::min<std::size_t>(inHand, threadsToRun());
    if (threads_.size() >= wanted)
        return;
    try
    {
        threads_.emplace_back(&ThreadPoolExecutor::work, this, static_cast<unsigned>(threads_.size()));
    }
    catch (const std::system_error&)
    {
        // The system gives no more threads: those there are do the work, only none at all is an error.
        if (threads_.empty() && !worksHere())
            throw;
    }
}

void ThreadPoolExecutor::promote(CheckId check)
{
    const std::lock_guard lock(mutex_);
    const auto place = std::ranges::find(speculative_, check);
    if (place == speculative_.end())
        return;
    speculative_.erase(place);
    demanded_.push_back(check);
}

void ThreadPoolExecutor::collect(std::vector<Completion>& out, std::chrono::milliseconds patience)
{
    if (inHand_ == 0)
        return;
    adaptToBudget();
    const std::size_t before = out.size();
    {
        Lock lock(mutex_);
        if (finished_.empty() && patience.count() > 0 && !workInstead(lock, out))
            waitForResult(lock, patience);
        take(out);
    }
    for (std::size_t i = before; i < out.size(); ++i)
        learn(out[i]);
    noteHandedBack(out.size() - before);
}

void ThreadPoolExecutor::noteHandedBack(std::size_t count)
{
    inHand_ -= count;
    stop_.share(inHand_ > 0);
}

void ThreadPoolExecutor::take(std::vector<Completion>& out)
{
    std::ranges::move(finished_, std::back_inserter(out));
    finished_.clear();
    done_.store(0, std::memory_order_relaxed);
}

/// Runs a queued check in the search thread, if that is a worker. Leaves the lock as it found it.
bool ThreadPoolExecutor::workInstead(Lock& lock, std::vector<Completion>& out)
{
    if (!worksHere() || (demanded_.empty() && speculative_.empty()) || stop_.isSet())
        return false;
    const CheckId check = popQueue();
    lock.unlock();
    out.push_back(runner_.run(checker_, check, workers_ - 1));
    out.back().here = true;
    lock.lock();
    return true;
}

void ThreadPoolExecutor::waitForResult(Lock& lock, std::chrono::milliseconds patience)
{
    if (usedWorkers() <= processors_)
    {
        lock.unlock();
        spin(PoolRules::kSearchSpins, [this] { return done_.load(std::memory_order_relaxed) > 0; });
        lock.lock();
    }
    searchWaits_ = true;
    resultAvailable_.wait_for(lock, patience, [this] { return !finished_.empty(); });
    searchWaits_ = false;
}

void ThreadPoolExecutor::learn(const Completion& completion)
{
    if (!completion.measured)
        return;
    if (completion.busyShare >= 0.0 && completion.seconds > kTellingSeconds)
        busyChecks_.add(completion.busyShare > kBusyShare);
    supply_.learn(completion.check, completion.seconds);
    const double motion = checker_.stopsInside() ? 0.0 : supply_.mean(1);
    longChecks_ = PoolRules::isLong(std::max(supply_.mean(0), motion), longChecks_);
    adaptThreads();
}

/// Uses what the budget has for this planner now. Not between a look at `worksHere` and the check that is run then.
void ThreadPoolExecutor::adaptToBudget()
{
    if (!share_)
        return;
    const unsigned mayUse = 1 + share_->limit();
    if (mayUse == mayUse_)
        return;
    mayUse_ = mayUse;
    adaptThreads();
}

/// Lets as many threads run as there should be now.
void ThreadPoolExecutor::adaptThreads()
{
    const unsigned limit = threadsToRun();
    if (limit == threadLimit_.load(std::memory_order_relaxed) && searchThreadShouldWork() == lastIsReserved_)
        return;
    {
        const std::lock_guard lock(mutex_);
        threadLimit_ = limit;
        lastIsReserved_ = searchThreadShouldWork();
        sleepers_ = 0;
    }
    workAvailable_.notify_all();
    if (share_)
        share_->wake();  // they may have no need to borrow any more
}

void ThreadPoolExecutor::cancelQueued(std::vector<CheckId>& dropped)
{
    const std::size_t before = dropped.size();
    {
        const std::lock_guard lock(mutex_);
        dropped.insert(dropped.end(), demanded_.begin(), demanded_.end());
        dropped.insert(dropped.end(), speculative_.begin(), speculative_.end());
        demanded_.clear();
        speculative_.clear();
        for (auto& count : queued_)
            count.store(0, std::memory_order_relaxed);
    }
    noteHandedBack(dropped.size() - before);
}

void ThreadPoolExecutor::cancelUnwanted(const std::function<bool(CheckId)>& isWanted, std::vector<CheckId>& dropped)
{
    if (queued() == 0)
        return;
    const std::size_t before = dropped.size();
    {
        const std::lock_guard lock(mutex_);
        takeUnwanted(speculative_, isWanted, dropped);
        for (std::size_t i = before; i < dropped.size(); ++i)
            queued_[kindOf(dropped[i])].fetch_sub(1, std::memory_order_relaxed);
    }
    noteHandedBack(dropped.size() - before);
}

double ThreadPoolExecutor::now() const noexcept
{
    return steadySeconds();
}

CheckId ThreadPoolExecutor::popQueue()
{
    std::deque<CheckId>& queue = demanded_.empty() ? speculative_ : demanded_;
    const CheckId check = queue.front();
    queue.pop_front();
    queued_[kindOf(check)].fetch_sub(1, std::memory_order_relaxed);
    return check;
}

bool ThreadPoolExecutor::hasWork() const
{
    return !(demanded_.empty() && speculative_.empty()) && running_ < threadLimit_;
}

unsigned ThreadPoolExecutor::takeNumber(unsigned worker)
{
    const auto isFree = [this](unsigned number)
    { return !numberTaken_[number] && !(lastIsReserved_ && number == workers_ - 1); };
    unsigned number = worker;
    if (!isFree(number))
        for (number = 0; !isFree(number);)
            ++number;
    numberTaken_[number] = true;
    lastNumberTaken_ = lastNumberTaken_ || number == workers_ - 1;
    return number;
}

void ThreadPoolExecutor::giveNumberBack(unsigned number)
{
    numberTaken_[number] = false;
    lastNumberTaken_ = lastNumberTaken_ && number != workers_ - 1;
}

void ThreadPoolExecutor::work(unsigned worker)
{
    InlineRunner runner(true);
    Lock lock(mutex_);
    for (bool isNew = true;; isNew = false)
    {
        if (!hasWork())
            waitForWork(lock, !isNew);
        if (ending_)
            return;
        if (!stop_.allows())
        {
            lock.unlock();
            stop_.waitToBegin();
            lock.lock();
            continue;
        }
        const bool borrows = needsToBorrow();
        if (borrows && !borrow(lock))
            continue;
        if (!borrows && share_)
            ownTaken_ = true;
        Completion completion = runAsWorker(lock, runner, worker);
        if (borrows)
            share_->giveBack();
        else
            ownTaken_ = false;
        finished_.push_back(std::move(completion));
        done_.fetch_add(1, std::memory_order_relaxed);
        if (std::exchange(searchWaits_, false))
            resultAvailable_.notify_one();
    }
}

/// Runs the next check of the queue without the lock.
Completion ThreadPoolExecutor::runAsWorker(Lock& lock, InlineRunner& runner, unsigned worker)
{
    const CheckId check = popQueue();
    const unsigned number = takeNumber(worker);
    ++running_;

    lock.unlock();
    Completion completion = runner.run(checker_, check, number);
    lock.lock();

    --running_;
    giveNumberBack(number);
    return completion;
}

/// Whether the planner's own thread in the budget is not free for the calling one.
bool ThreadPoolExecutor::needsToBorrow() const noexcept
{
    return share_ && (lastIsReserved_ || ownTaken_);
}

/// Waits for a thread of the budget, without the lock. \return false if there is nothing to run with it now; it is
/// given back then.
bool ThreadPoolExecutor::borrow(Lock& lock)
{
    lock.unlock();
    const bool borrowed = share_->borrow([this] { return ending_ || queued() == 0 || !needsToBorrow(); });
    lock.lock();
    if (borrowed && !ending_ && hasWork() && stop_.allows())
        return true;
    if (borrowed)
        share_->giveBack();
    return false;
}

/// Whether the calling thread has the processor that the search was on: on a busy machine a thread that is woken often
/// comes to run there, and as long as it does the search cannot go on.
bool ThreadPoolExecutor::keepsSearchOff() const noexcept
{
    const int processor = currentProcessor();
    return processor >= 0 && processor == searchProcessor_.load(std::memory_order_relaxed);
}

/// Returns when there is work, or at the end. \param mayBeSoon whether it is worth while to stay awake for a moment.
void ThreadPoolExecutor::waitForWork(Lock& lock, bool mayBeSoon)
{
    if (mayBeSoon && threadLimit_ <= processors_ && running_ < threadLimit_)
    {
        lock.unlock();
        spin(PoolRules::kWorkerSpins,
             [this] { return queued() > 0 || ending_.load(std::memory_order_relaxed) || keepsSearchOff(); });
        lock.lock();
    }
    while (!ending_ && !hasWork())
    {
        ++sleepers_;  // whoever wakes this thread takes it off
        workAvailable_.wait(lock);
    }
}
}  // namespace specplan::validity
