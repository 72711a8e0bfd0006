// SPDX-License-Identifier: BSD-3-Clause
#include "Interrupt.h"

#include <atomic>

namespace specplan::command
{
namespace
{
std::atomic<bool> interruptNoted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "all that a signal handler may write");

extern "C" void noteInterrupt(int)
{
    interruptNoted = true;
}
}  // namespace

StopOnInterrupt::StopOnInterrupt()
{
    struct sigaction action = {};
    action.sa_handler = noteInterrupt;
    action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);  // the next one ends the program
    sigaction(SIGINT, nullptr, &before_);
    if (before_.sa_handler != SIG_IGN)
        sigaction(SIGINT, &action, nullptr);
}

StopOnInterrupt::~StopOnInterrupt()
{
    sigaction(SIGINT, &before_, nullptr);
}

bool interrupted()
{
    return interruptNoted;
}
}  // namespace specplan::command
