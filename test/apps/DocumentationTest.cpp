// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "Command.h"

namespace specplan::test
{
namespace
{
std::string projectFile(const std::string& name)
{
    std::ifstream file(SPECPLAN_SCENES_DIR "/../../" + name);
    EXPECT_TRUE(file) << name;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Documentation, ReadmeQuotesTheDropInDemoAsItIs)
{
    const std::string demo = projectFile("demos/drop_in.cpp");
    const auto begin = demo.find("bool isValid(");
    ASSERT_NE(begin, std::string::npos);
    EXPECT_NE(projectFile("README.md").find(demo.substr(begin)), std::string::npos);
}

TEST(Documentation, HelpNamesEveryOptionOfTheReadme)
{
    const std::string help = call("plan --help").out + call("speedup --help").out + call("benchmark --help").out;
    const std::string readme = projectFile("README.md");
    int options = 0;
    for (auto at = readme.find(" --"); at != std::string::npos; at = readme.find(" --", at + 1))
    {
        const std::string option = readme.substr(at + 1, readme.find_first_of(" `=\n", at + 1) - at - 1);
        if (option == "--" || option == "--readme" || option == "-->")
            continue;  // of scripts/benchmark, and ends of comments
        EXPECT_NE(help.find(option), std::string::npos) << option;
        ++options;
    }
    EXPECT_GT(options, 5);
}
}  // namespace
}  // namespace specplan::test
