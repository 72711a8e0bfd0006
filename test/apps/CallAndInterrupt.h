// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

namespace specplan::test
{
/// Starts the command, sends Ctrl-C after each of these times, and waits for its end. \return the exit status, or minus
/// the signal that ended it.
inline int callAndInterrupt(std::vector<std::string> arguments, const std::string& out,
                            const std::vector<std::chrono::milliseconds>& after)
{
    const pid_t child = fork();
    if (child == 0)
    {
        std::vector<char*> words;
        std::string command = SPECPLAN_COMMAND;
        words.push_back(command.data());
        for (std::string& word : arguments)
            words.push_back(word.data());
        words.push_back(nullptr);
        signal(SIGINT, SIG_DFL);  // shells let jobs in the background ignore it
        if (std::freopen(out.c_str(), "w", stdout) != nullptr)
            execv(SPECPLAN_COMMAND, words.data());
        _exit(127);
    }
    for (const std::chrono::milliseconds pause : after)
    {
        std::this_thread::sleep_for(pause);
        kill(child, SIGINT);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}
}  // namespace specplan::test
