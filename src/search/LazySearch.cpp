// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/search/LazySearch.h"

#include <algorithm>
#include <utility>

#include "specplan/util/Hash.h"

namespace specplan::search
{
using validity::Verdict;

namespace
{
/// Nodes expanded between two questions whether to stop, and whether workers run dry.
constexpr std::size_t kPortion = 64;

/// Nodes that one guess may cost before it is left alone until it is known.
constexpr std::size_t kMostForGuess = 20000;

/// Checks that one decision may take together, and entries of OPEN among which it looks for doubtful ones.
constexpr std::size_t kTogether = 64;
constexpr std::size_t kLookedAt = 96;

/// The same for states that turned doubtful after ways were built on them: mostly few of those are needed.
constexpr std::size_t kSuspects = 4;

/// The same for what is handed out ahead of decisions, and the part of it that counts as the front.
constexpr std::size_t kLookedAhead = 4096;
constexpr std::size_t kFront = 341;

/// A check is guessed to be valid from this probability on: an obstacle goes on beside where it was met. A little less
/// will do where the answer decides on one step, not on the way to the goal.
constexpr double kLikely = 0.75;
constexpr double kLikelyStep = 0.65;
}  // namespace

LazySearch::LazySearch(lattice::Lattice& lattice, const lattice::Heuristic& heuristic, validity::Broker& broker,
                       double weight)
    : lattice_(lattice), broker_(broker), tree_(lattice, heuristic, weight), predictor_(lattice)
{
    tree_.setDoubt([this](NodeId node) { return predictor_.isDoubtful(node); });
}

SearchStatus LazySearch::run(const std::function<bool()>& stop)
{
    while (solution_.empty())
    {
        if (stop())
            return SearchStatus::Stopped;
        demanded_.clear();
        if (guesses_.empty())
        {
            switch (plan(kPortion))  // 1, 2: the best path, and what to check of it
            {
                case Plan::Unfinished:
                    lookedAhead_ = 0;
                    broker_.feed();
                    continue;
                case Plan::NoWay:
                    return SearchStatus::Infeasible;
                case Plan::Valid:  // 3
                    finish();
                    return SearchStatus::Solved;
                case Plan::Next:
                    demanded_ = next_;
            }
        }
        else
            for (std::size_t i = 0; i < endOfDecision(0); ++i)
                demanded_.push_back(guesses_[i].check);
        if (!broker_.demand(demanded_))  // 4
            return SearchStatus::Stopped;
        ++decisions_;
        for (const CheckId check : demanded_)
            commit(check, broker_.verdict(check) == Verdict::Valid);  // 5
    }
    return SearchStatus::Solved;
}

/// Brings the best path up to date and chooses the next checks, in the situation after all guesses.
LazySearch::Plan LazySearch::plan(std::size_t budget)
{
    while (plan_ == Plan::Unfinished)
    {
        if (chooseSuspects())
            return plan_;
        const std::uint64_t before = tree_.expansions();
        if (const LazyTree::Repair state = pathHolds_ ? LazyTree::Repair::Done : tree_.repair(budget);
            state != LazyTree::Repair::Done)
        {
            if (state == LazyTree::Repair::Doubtful)
                demandDoubtful();
            return plan_;
        }
        budget -= static_cast<std::size_t>(tree_.expansions() - before);
        if (tree_.nearestGoal() == lattice::kNoNode)
            return plan_ = Plan::NoWay;
        if (!pathHolds_ && !tree_.findPath(path_))
            continue;
        if (!std::exchange(pathHolds_, true))
            readPath();
        choose();
    }
    return plan_;
}

/// Of the nodes that turned doubtful while ways lead through them those are asked for that no way leads to through
/// another one: the others need not be asked for if that is invalid.
bool LazySearch::chooseSuspects()
{
    std::erase_if(suspects_, [this](NodeId node)
                  { return !tree_.isPassed(node) || tree_.verdict(CheckId::ofState(node)) != Verdict::Unknown; });
    if (suspects_.empty())
        return false;
    std::ranges::sort(suspects_, [this](NodeId a, NodeId b) { return tree_.comesBefore(a, b); });
    suspects_.erase(std::unique(suspects_.begin(), suspects_.end()), suspects_.end());
    next_.clear();
    for (std::size_t i = 0; i < suspects_.size() && next_.size() < kSuspects; ++i)
        if (!tree_.comesThrough(suspects_[i], std::span(suspects_).first(i)))
            next_.push_back(CheckId::ofState(suspects_[i]));
    plan_ = Plan::Next;
    lookedAhead_ = 0;
    return true;
}

/// Where the repair stands at a doubtful node, the next on OPEN mostly are as doubtful: they lie along one obstacle.
void LazySearch::demandDoubtful()
{
    tree_.doubtful(kLookedAt, doubtful_);
    next_.clear();
    for (const NodeId node : doubtful_)
        if (next_.size() < kTogether)
            next_.push_back(CheckId::ofState(node));
    lookedAhead_ = 0;
    plan_ = Plan::Next;
}

/// Lists what is unknown of the path, from the goal on.
void LazySearch::readPath()
{
    unknownStates_.clear();
    unknownGlances_.clear();
    unknownMotions_.clear();
    for (const LazyTree::EdgeId edge : path_)
    {
        listUnknown(CheckId::ofState(tree_.to(edge)));
        inner_.clear();
        tree_.addInner(edge, inner_);
        for (const CheckId check : inner_)
            listUnknown(check);
    }
}

void LazySearch::listUnknown(CheckId check)
{
    if (tree_.verdict(check) != Verdict::Unknown)
        return;
    listOf(check).push_back(check);
    if (!check.isMotion() || !isLong_ || !isLong_(lattice_.motion(check.motion())))
        return;
    if (const auto glance = lattice_.glanceOf(check.motion());
        glance && tree_.verdict(CheckId::ofMotion(*glance)) == Verdict::Unknown)
        unknownGlances_.push_back(CheckId::ofMotion(*glance));
}

std::vector<CheckId>& LazySearch::listOf(CheckId check) noexcept
{
    if (!check.isMotion())
        return unknownStates_;
    return lattice_.isGlance(check.motion()) ? unknownGlances_ : unknownMotions_;
}

/// States come first, then glances, then motions: the dearest last.
const std::vector<CheckId>& LazySearch::firstUnknown() const noexcept
{
    if (!unknownStates_.empty())
        return unknownStates_;
    return unknownGlances_.empty() ? unknownMotions_ : unknownGlances_;
}

void LazySearch::choose()
{
    inOrder_ = firstUnknown();
    switch (selector_)
    {
        case Selector::Forward:
            std::ranges::reverse(inOrder_);
            break;
        case Selector::Backward:
            break;
        case Selector::Alternate:
            std::ranges::reverse(inOrder_);
            for (std::size_t i = 1; i < inOrder_.size(); i += 2)
                std::rotate(inOrder_.begin() + static_cast<std::ptrdiff_t>(i), inOrder_.end() - 1, inOrder_.end());
            break;
        case Selector::LeastLikely:
            std::ranges::stable_sort(inOrder_, {}, [this](CheckId check) { return probabilityValid(check); });
            break;
    }
    lookedAhead_ = 0;
    next_.clear();
    for (const CheckId check : inOrder_)  // a state may lie on the path and beside it
        if (next_.size() < kTogether && std::ranges::find(next_, check) == next_.end())
            next_.push_back(check);
    plan_ = next_.empty() ? Plan::Valid : Plan::Next;
}

double LazySearch::probabilityValid(CheckId check) const
{
    return check.isMotion() ? predictor_.probabilityMotionValid() : predictor_.probabilityValid(check.node());
}

/// Obstacles go on: what is passed beside an invalid state may have to be taken back as well.
void LazySearch::suspectAround(NodeId node)
{
    lattice_.neighbours(node, neighbours_);
    for (const NodeId neighbour : neighbours_)
        if (tree_.isPassed(neighbour) && predictor_.isDoubtful(neighbour))
            suspects_.push_back(neighbour);
}

/// Draws the consequences of a verdict, real or guessed.
void LazySearch::enter(CheckId check, bool valid)
{
    if (!check.isMotion())
        predictor_.learned(check.node(), valid);
    tree_.enter(check, valid);
    plan_ = Plan::Unfinished;
    if (!valid)
    {
        pathHolds_ = false;
        if (!check.isMotion())
            suspectAround(check.node());
    }
    else
        std::erase(listOf(check), check);
}

/// Makes a decision final.
void LazySearch::commit(CheckId check, bool valid)
{
    if (!guesses_.empty() && guesses_.front().valid == valid)
    {
        guesses_.pop_front();  // foreseen, consequences and all
        if (guesses_.empty())
            tree_.record(nullptr);
    }
    else
    {
        takeBack(0);
        enter(check, valid);
    }
    note(check, valid);
}

void LazySearch::note(CheckId check, bool valid)
{
    ++steps_;
    const auto mixIn = [this](NodeId node)
    { orderHash_ = util::mix(orderHash_, util::hashCoordinates(lattice_.coordinates(node))); };
    if (check.isMotion())
    {
        mixIn(lattice_.motion(check.motion()).from);
        mixIn(lattice_.motion(check.motion()).to);
    }
    else
        mixIn(check.node());
    if (observer_)
        observer_(check, valid);
}

void LazySearch::addUnknown(CheckId check, std::size_t most, std::vector<CheckId>& out) const
{
    if (out.size() < most && broker_.verdict(check) == Verdict::Unknown && std::ranges::find(out, check) == out.end())
        out.push_back(check);
}

/// What else there is to be asked for in the situation as it is. Much of it will be, whatever the next check tells.
void LazySearch::proposeAtHand(std::size_t count, std::vector<CheckId>& out)
{
    if (!guesses_.empty() || (!isAmidRepair() && plan(kMostForGuess) != Plan::Next))
        return;
    const std::size_t most = out.size() + count;
    if (!isAmidRepair())
    {
        for (const CheckId check : next_)
            addUnknown(check, most, out);
        for (const NodeId suspect : suspects_)
            addUnknown(CheckId::ofState(suspect), most, out);
        if (pathHolds_)
            for (const CheckId check : firstUnknown())
                addUnknown(check, most, out);
    }
    lookAhead(most, out);
}

/// What is doubtful on OPEN, near its front and further back: it will be asked for sooner or later. The front is looked
/// at anew for each decision, the rest goes round.
void LazySearch::lookAhead(std::size_t most, std::vector<CheckId>& out)
{
    const std::span<const LazyTree::OpenEntry> open = tree_.open();
    const std::size_t front = std::min(kFront, open.size());
    const std::size_t rest = std::min(kLookedAhead, open.size()) - front;
    for (; lookedAhead_ < front + std::min(kFront, rest) && out.size() < most; ++lookedAhead_)
    {
        const std::size_t place = lookedAhead_ < front ? lookedAhead_ : front + goneRound_++ % rest;
        if (tree_.isDoubtful(open[place]))
            addUnknown(CheckId::ofState(open[place].item), most, out);
    }
}

void LazySearch::propose(std::size_t count, std::vector<CheckId>& out)
{
    if (isAmidRepair())
        return;
    const std::size_t most = out.size() + count;
    stuck_ = stuck_ && !guesses_.empty();
    for (std::size_t steps = 4 * count + 16; out.size() < most && steps > 0 && !stuck_; --steps)
    {
        Plan plan = Plan::Unfinished;
        while ((plan = this->plan(kPortion)) == Plan::Unfinished && (spentOnGuess_ += kPortion) < kMostForGuess)
            if (broker_.workersRunDry())
                return;  // goes on when asked again
        stuck_ = plan == Plan::Unfinished;
        if (stuck_ || plan == Plan::NoWay)
            return;
        if (plan == Plan::Valid)
        {
            if (!doubtPath())
                return;
            continue;
        }
        for (const CheckId check : next_)
            addUnknown(check, most, out);
        for (const NodeId suspect : suspects_)
            addUnknown(CheckId::ofState(suspect), most, out);
        guessed_.clear();
        for (const CheckId check : next_)
        {
            const Verdict verdict = broker_.verdict(check);
            guessed_.push_back({check, validity::isKnown(verdict) ? verdict == Verdict::Valid : isLikely(check),
                                probabilityValid(check)});
        }
        guess(guessed_);
        if (broker_.workersRunDry())
            return;  // what there is now is of more use than more of it later
    }
}

/// Whether to go on as if a check came out valid.
bool LazySearch::isLikely(CheckId check) const
{
    const bool isStep = !pathHolds_ && suspects_.empty();
    return probabilityValid(check) >= (isStep ? kLikelyStep : kLikely) ||
           (!check.isMotion() && tree_.isGoal(check.node()));
}

/// Goes on as if the checks of one decision had come out like this.
void LazySearch::guess(std::span<const Foreseen> decision)
{
    spentOnGuess_ = 0;
    for (const Foreseen& foreseen : decision)
    {
        guesses_.push_back({{foreseen}, &foreseen == &decision.back(), suspects_, {}});
        tree_.record(&guesses_.back().journal);
        enter(foreseen.check, foreseen.valid);
    }
}

/// Of the decision that a guess belongs to.
std::size_t LazySearch::beginOfDecision(std::size_t guess) const
{
    while (guess > 0 && !guesses_[guess - 1].isLast)
        --guess;
    return guess;
}

std::size_t LazySearch::endOfDecision(std::size_t guess) const
{
    while (!guesses_[guess].isLast)
        ++guess;
    return guess + 1;
}

/// The guesses lead to a goal: looks for the weakest of those that hope for the best, and goes on as if it were wrong.
bool LazySearch::doubtPath()
{
    std::size_t weakest = guesses_.size();
    for (std::size_t i = 0; i < guesses_.size(); ++i)
    {
        const Guess& guess = guesses_[i];
        if (guess.valid && !validity::isKnown(broker_.verdict(guess.check)) &&
            !(!guess.check.isMotion() && tree_.isGoal(guess.check.node())) &&
            (weakest == guesses_.size() || guess.probability < guesses_[weakest].probability))
            weakest = i;
    }
    if (weakest == guesses_.size())
        return false;
    const std::size_t first = beginOfDecision(weakest);
    guessed_.clear();
    for (std::size_t i = first; i < endOfDecision(weakest); ++i)
        guessed_.push_back({guesses_[i].check, guesses_[i].valid && i != weakest, guesses_[i].probability});
    takeBack(first);
    guess(guessed_);
    return true;
}

/// Takes back all guesses from this one on.
void LazySearch::takeBack(std::size_t first)
{
    if (first >= guesses_.size())
        return;
    tree_.record(nullptr);
    for (; guesses_.size() > first; guesses_.pop_back())
    {
        const Guess& guess = guesses_.back();
        tree_.undo(guess.check, guess.journal);
        if (!guess.check.isMotion())
            predictor_.forget(guess.check.node(), guess.valid);
        suspects_ = guess.suspects;
    }
    if (!guesses_.empty())
        tree_.record(&guesses_.back().journal);
    plan_ = Plan::Unfinished;
    pathHolds_ = false;
    stuck_ = false;
    spentOnGuess_ = 0;
}

void LazySearch::learned(CheckId check, bool valid)
{
    const auto place = std::ranges::find(guesses_, check, &Guess::check);
    if (place != guesses_.end() && place->valid != valid)
        takeBack(beginOfDecision(static_cast<std::size_t>(place - guesses_.begin())));
}

void LazySearch::missed()
{
    takeBack(0);
}

bool LazySearch::stillWanted(CheckId check) const
{
    // What is doubtful is asked for sooner or later, whatever comes before it.
    return (!check.isMotion() && predictor_.isDoubtful(check.node())) ||
           std::ranges::find(guesses_, check, &Guess::check) != guesses_.end();
}

/// Keeps the path with its costs as the lattice has them, not rounded.
void LazySearch::finish()
{
    solution_.assign(1, path_.empty() ? tree_.nearestGoal() : tree_.from(path_.back()));
    solutionCosts_.assign(1, 0.0);
    for (auto place = path_.rbegin(); place != path_.rend(); ++place)
    {
        const LazyTree::EdgeId edge = *place;
        lattice_.successors(tree_.from(edge), successors_);
        solution_.push_back(tree_.to(edge));
        solutionCosts_.push_back(solutionCosts_.back() + successors_.edges[tree_.indexOf(edge)].cost);
    }
}

std::vector<NodeId> LazySearch::pathTo(NodeId node) const
{
    const auto place = std::ranges::find(solution_, node);
    return place == solution_.end() ? std::vector<NodeId>{} : std::vector<NodeId>(solution_.begin(), place + 1);
}

double LazySearch::costToCome(NodeId node) const noexcept
{
    const auto place = std::ranges::find(solution_, node);
    return place == solution_.end() ? LazyTree::kUnreached
                                    : solutionCosts_[static_cast<std::size_t>(place - solution_.begin())];
}

NodeId LazySearch::parent(NodeId node) const noexcept
{
    const auto place = std::ranges::find(solution_, node);
    return place == solution_.end() || place == solution_.begin() ? lattice::kNoNode : *(place - 1);
}
}  // namespace specplan::search
