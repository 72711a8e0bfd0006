// SPDX-License-Identifier: BSD-3-Clause
// What the build makes of the command's own definitions: manual page and completions; and the help.
#include <gtest/gtest.h>

#include <array>
#include <regex>

#include "Command.h"

namespace specplan::test
{
namespace
{
/// The long options that a subcommand's help names.
std::vector<std::string> optionsOf(const std::string& subcommand)
{
    const std::string help = call(subcommand + " --help").out;
    const std::regex option("\n  (-h,)?(--[a-z-]+)");
    std::vector<std::string> options;
    for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at)
        options.push_back((*at)[2]);
    return options;
}

constexpr std::array<const char*, 3> kSubcommands{"plan", "benchmark", "speedup"};

TEST(Help, NamesTheExitStatuses)
{
    for (const char* how : {"--help", "plan --help", "speedup --help", "benchmark --help"})
        for (const char* status : {"\n  0    solved", "\n  1    not solved", "\n  2    bad usage", "\n  3    a fault",
                                   "\n  130  stopped by Ctrl-C"})
            EXPECT_NE(call(how).out.find(status), std::string::npos) << how;
}

TEST(ManPage, NamesEveryOptionAndIsCleanRoff)
{
    const Outcome page = call("--man");
    EXPECT_EQ(page.status, 0);
    EXPECT_EQ(page.out.rfind(".TH SPECPLAN 1", 0), 0U);
    for (const char* subcommand : kSubcommands)
        for (std::string option : optionsOf(subcommand))
        {
            option = std::regex_replace(option, std::regex("-"), "\\-");
            EXPECT_NE(page.out.find("\\fB" + option), std::string::npos) << option;
        }
    EXPECT_NE(page.out.find(".TP\n130\nstopped by Ctrl\\-C\n"), std::string::npos);
    EXPECT_EQ(
        shell("command -v groff >/dev/null || exit 0; \"$SPECPLAN\" --man | groff -man -Tascii -ww >/dev/null").err,
        "");
}

TEST(Completion, OfBashKnowsSubcommandsOptionsAndWords)
{
    const TemporaryFolder folder;
    const std::string script = folder.write("completion", call("--completion bash").out);
    const auto in = [&script](const std::string& words)
    {
        return shell("bash --norc -c '. \"$0\"; COMP_WORDS=(" + words +
                     "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _specplan; echo \"${COMPREPLY[@]}\"' '" + script + "'")
            .out;
    };
    EXPECT_EQ(in("specplan \"\""), "plan benchmark speedup --help --version\n");
    EXPECT_EQ(in("specplan sp"), "speedup\n");
    EXPECT_EQ(in("specplan plan --policy \"\""), "none direction runahead\n");
    EXPECT_EQ(in("specplan plan --exe"), "--executor\n");
    EXPECT_EQ(in("specplan plan --cost s"), "steps seed\n");
    for (const char* subcommand : kSubcommands)
        for (const std::string& option : optionsOf(subcommand))
            EXPECT_NE((' ' + in(std::string("specplan ") + subcommand + " --")).find(' ' + option), std::string::npos)
                << subcommand << ' ' << option;
}

TEST(Completion, OfZshNamesEveryOption)
{
    const Outcome script = call("--completion zsh");
    EXPECT_EQ(script.out.rfind("#compdef specplan\n", 0), 0U);
    for (const char* subcommand : kSubcommands)
        for (const std::string& option : optionsOf(subcommand))
            EXPECT_NE(script.out.find('\'' + option + '['), std::string::npos) << option;
    EXPECT_EQ(call("--completion fish").status, 2);
}
}  // namespace
}  // namespace specplan::test
