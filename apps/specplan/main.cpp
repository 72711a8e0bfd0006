// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

int main(int argc, char** argv)
{
    return specplan::command::run(argc, argv);
}
