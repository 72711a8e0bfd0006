// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <locale>
#include <string>

#include "specplan/util/ParseNumber.h"

namespace specplan::test
{
namespace
{
using Parse = bool (*)(std::string_view, double&);

/// Which way of reading: the standard library's, or that by stream for libraries without one.
class ParseNumber : public testing::TestWithParam<Parse>
{
};

TEST_P(ParseNumber, ReadsWhatIsANumber)
{
    const struct
    {
        std::string text;
        double number;
    } cases[] = {{"0", 0.0},
                 {"-0", 0.0},
                 {"0e5", 0.0},
                 {"7", 7.0},
                 {"-7.25", -7.25},
                 {".5", 0.5},
                 {"5.", 5.0},
                 {"1e3", 1000.0},
                 {"1E+3", 1000.0},
                 {"2.5e-3", 0.0025},
                 {"0.1", 0.1},
                 {"1.7976931348623157e308", std::numeric_limits<double>::max()},
                 {"2.2250738585072014e-308", std::numeric_limits<double>::min()}};
    for (const auto& [text, expected] : cases)
    {
        double number = 99.0;
        EXPECT_TRUE(GetParam()(text, number)) << text;
        EXPECT_EQ(number, expected) << text;
    }
}

TEST_P(ParseNumber, RefusesEverythingElseAndLeavesTheNumberAlone)
{
    for (const std::string text :
         {"",    " ",        "+1",    " 1",     "1 ",     "1\n",   "1,5",   "1.5x",  "x",   "-",
          ".",   "e5",       "1e",    "1e+",    "--1",    "1.2.3", "0x10",  "0x1p3", "inf", "-inf",
          "nan", "infinity", "1e400", "-1e400", "1e-400", "1 2",   "1_000", "1'000"})
    {
        double number = 99.0;
        EXPECT_FALSE(GetParam()(text, number)) << "'" << text << "'";
        EXPECT_EQ(number, 99.0) << "'" << text << "'";
    }
    double number = 99.0;
    EXPECT_FALSE(GetParam()(std::string_view("1\0", 2), number));
}

/// A locale with a comma for a point and dots between thousands.
class Commas : public std::numpunct<char>
{
    char do_decimal_point() const override
    {
        return ',';
    }
    char do_thousands_sep() const override
    {
        return '.';
    }
    std::string do_grouping() const override
    {
        return "\3";
    }
};

TEST_P(ParseNumber, DoesNotCareForTheLocale)
{
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
    double number = 0.0;
    EXPECT_TRUE(GetParam()("1.5", number));
    EXPECT_EQ(number, 1.5);
    EXPECT_FALSE(GetParam()("1,5", number));
    std::locale::global(before);
}

INSTANTIATE_TEST_SUITE_P(Either, ParseNumber, testing::Values(&util::parseNumber, &util::parseNumberByStream),
                         [](const auto& instance) { return instance.index == 0 ? "Library" : "Stream"; });
}  // namespace
}  // namespace specplan::test
