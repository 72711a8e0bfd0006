// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/TracingChecker.h"

#include <algorithm>

#include "specplan/validity/RunCheck.h"

namespace specplan::planner
{
using validity::CheckId;

bool TracingChecker::check(CheckId check, unsigned worker)
{
    if (!replays_)
        return run(check, worker);
    const CheckTrace::Entry* known = trace_->find(checker_.lattice(), check);
    if (known == nullptr)
    {
        lastSeconds_ = 0.0;  // should it throw
        const bool valid = run(check, worker);
        lastSeconds_ = workers_[worker].notes.back().seconds;
        absorb();
        return valid;
    }
    lastSeconds_ = known->seconds;
    if (check.isMotion() && checker_.costs() != nullptr && known->valid)
        checker_.costs()->set(check.motion(), known->cost);
    return known->valid;
}

bool TracingChecker::run(CheckId check, unsigned worker)
{
    const double start = validity::steadySeconds();
    const bool valid = checker_.check(check, worker);
    workers_[worker].notes.push_back({check, valid, start, validity::steadySeconds() - start, worker});
    return valid;
}

void TracingChecker::absorb()
{
    for (Worker& worker : workers_)
        for (; worker.absorbed < worker.notes.size(); ++worker.absorbed)
        {
            const Note& note = worker.notes[worker.absorbed];
            CheckTrace::Entry entry;
            entry.seconds = note.seconds;
            entry.valid = note.valid;
            if (note.check.isMotion() && note.valid && checker_.costs() != nullptr)
                entry.cost = checker_.costs()->evaluated(note.check.motion());
            trace_->add(checker_.lattice(), note.check, entry);
        }
}

std::vector<TracingChecker::Note> TracingChecker::notes() const
{
    std::vector<Note> all;
    for (const Worker& worker : workers_)
        all.insert(all.end(), worker.notes.begin(), worker.notes.end());
    std::ranges::sort(all, {}, &Note::start);
    return all;
}

void TracingChecker::clearNotes()
{
    for (Worker& worker : workers_)
        worker = {};
}
}  // namespace specplan::planner
