// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <ompl/util/Exception.h>

#include "Scene.h"

namespace specplan::test
{
namespace
{
TEST(Parameters, BadValuesAreRefusedAndTheOldOneStays)
{
    Scene scene;
    SpeculativeAStar planner(scene.setup.getSpaceInformation());
    auto& params = planner.params();
    for (const char* name :
         {"num_threads", "lookahead", "weight", "resolution", "connectivity", "virtual_check_cost", "barrier",
          "corner_cutting", "rethrow_exceptions", "speculation_policy", "executor", "spacing"})
        for (const char* bad : {"-1", "nan", "inf", "7.9x", "maybe", "99999999999999999999", " 1"})
        {
            if (std::string(name) == "spacing" && std::string(bad) == " 1")
                continue;  // blanks are well there
            const std::string before = params[name].getValue();
            EXPECT_FALSE(params.setParam(name, bad)) << name << " = '" << bad << "'";
            EXPECT_EQ(params[name].getValue(), before);
        }
    EXPECT_FALSE(params.setParam("num_threads", "7.9"));
    EXPECT_FALSE(params.setParam("num_threads", "5000"));
    EXPECT_FALSE(params.setParam("weight", "0.5"));
    EXPECT_FALSE(params.setParam("resolution", "2"));
    EXPECT_FALSE(params.setParam("lookahead", "0"));
    EXPECT_FALSE(params.setParam("no_such_parameter", "1"));
}

/// What is wrong with the settings; empty if nothing is.
std::string refusal(const PlannerSettings& settings)
{
    try
    {
        Scene scene;
        SpeculativeAStar planner(scene.setup.getSpaceInformation(), settings);
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "";
}

TEST(Parameters, TheMessageNamesParameterRangeAndValue)
{
    PlannerSettings settings;
    EXPECT_EQ(refusal(settings), "");
    settings.weight = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(settings), "weight must be 0, or between 1 and 1e+09, not 'nan'");
    settings = {};
    settings.executor = "gpu";
    EXPECT_EQ(refusal(settings), "executor must be threads or virtual, not 'gpu'");
}

TEST(Parameters, TheMessageIsOnePrintableLineWhateverTheValue)
{
    PlannerSettings settings;
    settings.executor = "\x1b[2Jthreads\n";
    EXPECT_EQ(refusal(settings), "executor must be threads or virtual, not '\\x1b[2Jthreads\\n'");
    settings = {};
    settings.evaluation = std::string(1000, 'x');
    EXPECT_NE(refusal(settings).find(", not '" + std::string(60, 'x') + "...'"), std::string::npos)
        << refusal(settings);
}

TEST(Parameters, NoMeansNo)
{
    Scene scene;
    SpeculativeAStar planner(scene.setup.getSpaceInformation());
    EXPECT_TRUE(planner.params().setParam("corner_cutting", "no"));
    EXPECT_FALSE(planner.getSettings().cornerCutting);
    EXPECT_TRUE(planner.params().setParam("corner_cutting", "yes"));
    EXPECT_TRUE(planner.getSettings().cornerCutting);
}

TEST(Parameters, RoundTripThroughStrings)
{
    Scene scene;
    SpeculativeAStar one(scene.setup.getSpaceInformation());
    const std::map<std::string, std::string> values{{"num_threads", "12"},
                                                    {"speculation_policy", "none"},
                                                    {"predictor", "nearby"},
                                                    {"lookahead", "7"},
                                                    {"barrier", "1"},
                                                    {"weight", "2.5"},
                                                    {"resolution", "0.013"},
                                                    {"spacing", "0.1,0.25"},
                                                    {"connectivity", "1"},
                                                    {"corner_cutting", "0"},
                                                    {"executor", "virtual"},
                                                    {"virtual_check_cost", "0.005"},
                                                    {"rethrow_exceptions", "1"},
                                                    {"anytime", "0"},
                                                    {"stop_at_first_path", "1"},
                                                    {"evaluation", "lazy"},
                                                    {"objective_in_checks", "0"}};
    ASSERT_TRUE(one.params().setParams(values));
    std::map<std::string, std::string> read;
    one.params().getParams(read);
    EXPECT_EQ(read, values);
}

TEST(Parameters, SpacingMayBeAnArrayThatBecameAString)
{
    Scene scene;
    SpeculativeAStar planner(scene.setup.getSpaceInformation());
    auto& params = planner.params();
    for (const char* good :
         {"[0.2, 0.1]", "0.2,0.1", "0.2;0.1", "0.2 0.1", " [ 0.2 ;0.1 ] ", "[0.2\t0.1]", "0.2 , 0.1", "[0.2,0.1]"})
    {
        EXPECT_TRUE(params.setParam("spacing", "1")) << good;
        EXPECT_TRUE(params.setParam("spacing", good)) << good;
        EXPECT_EQ(planner.getSettings().spacing, (std::vector<double>{0.2, 0.1})) << good;
    }
    for (const char* bad : {"[0.2, 0.1", "0.2, 0.1]", "0.2,,0.1", "0.2,", ",0.2", "[[0.2]]", "(0.2)", "[0.2, zero]",
                            "0.2 x", "[0.2; -1]", "0.2\n0.1"})
    {
        EXPECT_FALSE(params.setParam("spacing", bad)) << bad;
        EXPECT_EQ(planner.getSettings().spacing, (std::vector<double>{0.2, 0.1})) << bad;
    }
    for (const char* none : {"", "[]", " [ ] "})
    {
        EXPECT_TRUE(params.setParam("spacing", "1")) << none;
        EXPECT_TRUE(params.setParam("spacing", none)) << none;
        EXPECT_TRUE(planner.getSettings().spacing.empty()) << none;
    }
}

TEST(Parameters, AreAllDocumentedWithTheirDefaultsAndRanges)
{
    std::ifstream file(SPECPLAN_DOCS_DIR "/parameters.md");
    ASSERT_TRUE(file) << "docs/parameters.md is missing";
    std::stringstream text;
    text << file.rdbuf();
    Scene scene;
    SpeculativeAStar planner(scene.setup.getSpaceInformation());
    std::vector<std::string> names;
    planner.params().getParamNames(names);
    EXPECT_EQ(names.size(), 17U);
    for (const std::string& name : names)
    {
        const auto& param = planner.params()[name];
        const std::string value = param.getValue().empty() ? "" : "`" + param.getValue() + "`";
        const std::string range = param.getRangeSuggestion().empty() ? "" : "`" + param.getRangeSuggestion() + "`";
        EXPECT_NE(text.str().find("| `" + name + "` | " + value + " | " + range + " |"), std::string::npos)
            << "expected the row: | `" << name << "` | " << value << " | " << range << " |";
    }
}

TEST(Parameters, SettingsThatDoNotFitTheSpaceAreReported)
{
    Scene scene;
    PlannerSettings settings = settingsFor(1);
    settings.spacing = {0.1, 0.1, 0.1};
    scene.plan(settings);
    EXPECT_EQ(scene.solve(0.5), ob::PlannerStatus::CRASH);
    EXPECT_NE(scene.planner->getReport().error.find("spacing has 3 values"), std::string::npos);
    settings.spacing = {};
    settings.connectivity = 5;
    EXPECT_NO_THROW(scene.planner->setup()) << "warns";
    scene.planner->setSettings(settings);
    EXPECT_EQ(scene.solve(0.5), ob::PlannerStatus::CRASH);
    EXPECT_NE(scene.planner->getReport().error.find("connectivity is 5"), std::string::npos);
}

TEST(Parameters, NumbersInMessagesAreWrittenPlainly)
{
    Scene scene;
    SpeculativeAStar planner(scene.setup.getSpaceInformation());
    const auto said = [&planner](const PlannerSettings& settings)
    {
        try
        {
            planner.setSettings(settings);
        }
        catch (const std::invalid_argument& error)
        {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    PlannerSettings threads;
    threads.numThreads = 5000;
    EXPECT_EQ(said(threads), "num_threads must be between 0 and 4096, not '5000'");
    PlannerSettings lookahead;
    lookahead.lookahead = 0;
    EXPECT_EQ(said(lookahead), "lookahead must be between 1 and 1000, not '0'");
    PlannerSettings resolution;
    resolution.resolution = 2.5;
    EXPECT_EQ(said(resolution), "resolution must be 0, or between 1e-06 and 1, not '2.5'");
}

TEST(Parameters, BoundsThatHaveNoMiddleAreNamed)
{
    for (const double bound : {1e300, std::numeric_limits<double>::infinity()})
    {
        Scene scene;
        ob::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(1.0);
        bounds.setHigh(1, bound);
        scene.space->setBounds(bounds);
        scene.space->setDimensionName(1, "height");
        scene.plan(settingsFor(1));
        EXPECT_EQ(scene.solve(1.0), ob::PlannerStatus::CRASH);
        EXPECT_NE(scene.planner->getReport().error.find("bounds of height"), std::string::npos)
            << scene.planner->getReport().error;
    }
}

TEST(Specs, AreHonest)
{
    Scene scene;
    const ob::PlannerSpecs specs = SpeculativeAStar(scene.setup.getSpaceInformation()).getSpecs();
    EXPECT_TRUE(specs.multithreaded);
    EXPECT_TRUE(specs.optimizingPaths);
    EXPECT_TRUE(specs.approximateSolutions);
    EXPECT_TRUE(specs.directed);
    EXPECT_TRUE(specs.provingSolutionNonExistence);
    EXPECT_TRUE(specs.canReportIntermediateSolutions);
}
}  // namespace
}  // namespace specplan::test
