// SPDX-License-Identifier: BSD-3-Clause
#include "ManPage.h"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <sstream>
#include <string>

#include "ExitStatus.h"
#include "specplan/Version.h"

namespace specplan::command
{
namespace
{
/// Text as roff wants it: what it would take for a command, or for a hyphen, is escaped.
std::string roff(const std::string& text)
{
    std::string out;
    for (const char letter : text)
        out += letter == '\\' ? "\\e" : letter == '-' ? "\\-" : std::string(1, letter);
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string upper(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string synopsis(const CLI::App& app)
{
    std::string text = "\\fBspecplan " + app.get_name() + "\\fR [\\fIOPTION\\fR]...";
    for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->get_positional(); }))
        text += " \\fI" + roff(option->get_name(true)) + "\\fR" + (option->get_items_expected_max() > 1 ? "..." : "");
    return text;
}

void writeOption(std::ostream& out, const CLI::Option& option)
{
    out << ".TP\n";
    if (option.get_positional())
        out << "\\fI" << roff(option.get_name(true)) << "\\fR";
    else
        out << "\\fB" << roff(option.get_name()) << "\\fR";
    if (!option.get_positional() && option.get_items_expected_max() > 0)
        out << " \\fI" << roff(option.get_type_name()) << "\\fR";
    out << '\n' << roff(option.get_description());
    if (!option.get_default_str().empty())
        out << " [" << roff(option.get_default_str()) << ']';
    out << '\n';
}

void writeExitStatus(std::ostream& out)
{
    out << ".SH EXIT STATUS\n";
    std::istringstream lines(kExitStatusText);
    std::string line;
    std::getline(lines, line);  // the heading
    while (std::getline(lines, line))
    {
        std::istringstream words(line);
        std::string status;
        words >> status >> std::ws;
        std::getline(words, line);
        out << ".TP\n" << status << '\n' << roff(line) << '\n';
    }
}
}  // namespace

void writeManPage(std::ostream& out, const CLI::App& app)
{
    const auto subcommands = app.get_subcommands([](const CLI::App*) { return true; });
    out << ".TH SPECPLAN 1 \"\" \"specplan " SPECPLAN_VERSION "\" \"User Commands\"\n"
        << ".SH NAME\nspecplan \\- " << roff(app.get_description()) << '\n'
        << ".SH SYNOPSIS\n";
    for (const CLI::App* subcommand : subcommands)
        out << synopsis(*subcommand) << "\n.br\n";
    out << "\\fBspecplan\\fR \\fB\\-\\-help\\fR | \\fB\\-\\-version\\fR\n"
        << ".SH DESCRIPTION\n"
        << "Each subcommand prints a table, or one JSON object. Bad input is refused with one line on standard error.\n"
        << "Files that options write keep their permissions; links, pipes and devices stay what they are. Where FILE "
           "is\n"
        << "\\- it is standard output, and the table goes to standard error.\n"
        << "Ctrl\\-C stops a search and keeps what it has found; a second one ends the program.\n";
    for (const CLI::App* subcommand : subcommands)
    {
        out << ".SH " << upper(subcommand->get_name()) << '\n'
            << synopsis(*subcommand) << "\n.PP\n"
            << roff(subcommand->get_description()) << ".\n";
        for (const CLI::Option* option : subcommand->get_options())
            if (!option->get_group().empty())
                writeOption(out, *option);
    }
    writeExitStatus(out);
}
}  // namespace specplan::command
