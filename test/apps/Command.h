// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include <nlohmann/json.hpp>

#include "TemporaryFolder.h"

namespace specplan::test
{
/// What a call of the command printed and returned.
struct Outcome
{
    int status;
    std::string out;
    std::string err;

    [[nodiscard]] nlohmann::json json() const
    {
        return nlohmann::json::parse(out);
    }
};

/// Runs a line in a shell, where $SPECPLAN is the command.
inline Outcome shell(const std::string& line)
{
    const TemporaryFolder folder;
    const std::string whole =
        "SPECPLAN='" SPECPLAN_COMMAND "'; (" + line + "\n) >'" + folder / "out" + "' 2>'" + folder / "err" + "'";
    const int status = std::system(whole.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder.read("out"), folder.read("err")};
}

/// Runs the command with these arguments, as a shell would.
inline Outcome call(const std::string& arguments)
{
    return shell("\"$SPECPLAN\" " + arguments);
}

inline std::string scene(const std::string& file)
{
    return std::string(SPECPLAN_SCENES_DIR "/") + file;
}

inline const std::string kCity = scene("city-64.map");
}  // namespace specplan::test
