// SPDX-License-Identifier: BSD-3-Clause
#include "Input.h"

#include <iostream>

#include "specplan/problems/TextFile.h"

namespace specplan::command
{
Input readInput(const std::string& file)
{
    if (file != "-")
        return {file, file, problems::readText(file)};
    constexpr const char* kName = "standard input";
    return {kName, "/dev/stdin", problems::readText(std::cin, kName)};
}
}  // namespace specplan::command
