// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

#include <ompl/util/Console.h>

#include "Benchmark.h"
#include "Completion.h"
#include "Definitions.h"
#include "ExitStatus.h"
#include "ManPage.h"
#include "Outputs.h"
#include "Plan.h"
#include "Speedup.h"
#include "specplan/Version.h"
#include "specplan/problems/InputError.h"

namespace specplan::command
{
using problems::concat;
using problems::InputError;
using problems::inQuotes;

namespace
{
/// What can be typed, and where it goes.
class CommandLine
{
public:
    CommandLine()
    {
        app_.set_version_flag("--version", SPECPLAN_VERSION);
        app_.require_subcommand(0, 1);
        app_.footer(kExitStatusText);  // subcommands take it over
        // For the build, which installs what they print.
        app_.add_flag("--man", man_, "Print the manual page")->group("");
        app_.add_option("--completion", shell_, "Print completions for bash or zsh")
            ->check(CLI::IsMember({"bash", "zsh"}))
            ->group("");
        plan_ = app_.add_subcommand("plan", "Solve one problem");
        benchmark_ = app_.add_subcommand("benchmark", "Run OMPL's Benchmark over several planners");
        speedup_ = app_.add_subcommand("speedup", "Measure every policy with every number of threads");
        definePlan(*plan_, planOptions_);
        defineBenchmark(*benchmark_, benchmarkOptions_);
        defineSpeedup(*speedup_, speedupOptions_);
    }

    /// \return the exit status. \throws CLI::Success for help and version. \throws InputError, CLI::ParseError.
    int run(int argc, char** argv)
    {
        parse(argc, argv);
        if (man_)
            writeManPage(std::cout, app_);
        else if (!shell_.empty())
            writeCompletion(std::cout, app_, shell_);
        else if (plan_->parsed())
            return runPlan();
        else if (benchmark_->parsed())
            return benchmark(benchmarkOptions_, std::cout);
        else if (speedup_->parsed())
            return runSpeedup();
        else
            throw InputError(concat("expected a subcommand: ", subcommands()));
        return kSolved;
    }

    /// Prints help or version. \return the exit status.
    int print(const CLI::Success& wish) const
    {
        return app_.exit(wish);
    }

private:
    void parse(int argc, char** argv)
    {
        try
        {
            app_.parse(argc, argv);
        }
        catch (const CLI::Success&)
        {
            throw;
        }
        catch (const CLI::ParseError&)
        {
            refuseUnknown();  // says more
            throw;
        }
        refuseEmptyValues();
    }

    /// \throws InputError that names the first word that nothing knows, if there is one.
    void refuseUnknown() const
    {
        const std::vector<std::string> unknown = app_.remaining(true);
        if (unknown.empty())
            return;
        const auto option =
            std::ranges::find_if(unknown, [](const std::string& each) { return each.starts_with('-'); });
        const std::string word = option != unknown.end() ? *option : unknown.front();
        const auto chosen = app_.get_subcommands();
        if (word.starts_with('-'))
            throw InputError(concat("unknown option ", inQuotes(word.substr(0, word.find('='))),
                                    chosen.empty() ? "" : " of " + chosen.front()->get_name()));
        if (chosen.empty())
            throw InputError(concat("unknown subcommand ", inQuotes(word), "; expected ", subcommands()));
        throw InputError(concat("PROBLEM: expected one, found ", inQuotes(word), " too"));
    }

    /// "$OUT" without OUT is empty, and means something else than no option.
    void refuseEmptyValues() const
    {
        for (const CLI::App* app : app_.get_subcommands())
            for (const CLI::Option* option : app->get_options())
                if (option->get_items_expected_max() > 0 && std::ranges::any_of(option->results(), &std::string::empty))
                    throw InputError(concat(option->get_name(), ": expected ",
                                            option->get_type_name().empty() ? "a file" : option->get_type_name(),
                                            ", found an empty value"));
    }

    [[nodiscard]] std::string subcommands() const
    {
        std::string all;
        for (const CLI::App* app : app_.get_subcommands([](const CLI::App*) { return true; }))
            all += (all.empty() ? "" : ", ") + app->get_name();
        return all;
    }

    static void requireOneStandardInput(const ProblemOptions& problem)
    {
        if (std::ranges::count(problem.files, "-") + (problem.scenario == "-" ? 1 : 0) > 1)
            throw InputError("standard input: expected once, found - for several files");
    }

    int runPlan() const
    {
        requireOneStandardInput(planOptions_.problem);
        return plan(planOptions_, std::cout);
    }

    int runSpeedup() const
    {
        const ProblemOptions& problem = speedupOptions_.problem;
        requireOneStandardInput(problem);
        if (problem.files.size() > 1 && (problem.start || problem.goal || !problem.scenario.empty()))
            throw InputError("--start, --goal and --scen: expected a single PROBLEM with these");
        return speedup(speedupOptions_, std::cout);
    }

    CLI::App app_{"Lattice planning with expensive validity checks, on many cores at once", "specplan"};
    bool man_ = false;
    std::string shell_;
    CLI::App* plan_;
    CLI::App* benchmark_;
    CLI::App* speedup_;
    PlanOptions planOptions_;
    BenchmarkOptions benchmarkOptions_;
    SpeedupOptions speedupOptions_;
};

int complain(const std::string& text, ExitStatus status)
{
    std::cerr << "specplan: " << problems::printable(text) << '\n';
    return status;
}

int runAndFlush(int argc, char** argv)
{
    CommandLine commandLine;
    int status = kSolved;
    try
    {
        status = commandLine.run(argc, argv);
    }
    catch (const CLI::Success& wish)
    {
        status = commandLine.print(wish);
    }
    requireWritten(std::cout);
    return status;
}
}  // namespace

int run(int argc, char** argv)
{
    keepStandardDescriptors();
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);  // standard output is for results
    try
    {
        return runAndFlush(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        return complain(concat(error.what(), " (see specplan --help)"), kBadInput);
    }
    catch (const std::bad_alloc&)
    {
        return complain("out of memory", kOwnFault);
    }
    catch (const std::logic_error& error)
    {
        return complain(error.what(), kOwnFault);
    }
    catch (const std::exception& error)
    {
        return complain(error.what(), kBadInput);
    }
}
}  // namespace specplan::command
